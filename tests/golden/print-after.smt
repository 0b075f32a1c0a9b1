# The machine after a pass of the optimiser goes to standard error; the product is made as ever.
args build a.sm --emit=ir --print-after=fold

-- a.sm --
[state_vector]
U64 G
U32 S
U8 x
[Idle]
.step
    x = 1 + 1
-- stdout --
machine "a"
vector "a" size 16 hash 0x160479d6

element U64 G at 0 is G
element U32 S at 8 is S
element U8 x writable at 12
time U64 T

state Idle
step {
b0:
    %0 = const U8 2
    store U8 x, %0
    ret
}
-- stderr --
# after fold
machine "a"
vector "a" size 16 hash 0x160479d6

element U64 G at 0 is G
element U32 S at 8 is S
element U8 x writable at 12
time U64 T

state Idle
step {
b0:
    %0 = const F64 1
    %1 = const F64 1
    %2 = const F64 2
    %3 = const U8 2
    store U8 x, %3
    ret
}
# after fold
machine "a"
vector "a" size 16 hash 0x160479d6

element U64 G at 0 is G
element U32 S at 8 is S
element U8 x writable at 12
time U64 T

state Idle
step {
b0:
    %0 = const U8 2
    store U8 x, %0
    ret
}
