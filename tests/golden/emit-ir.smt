# --emit=ir, at two levels.
args build --emit=ir -O0 a.sm
args build --emit=ir -O2 a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
machine "a"
vector "a" size 16 hash 0xb1dc9237

element U64 G at 0 is G
element U32 S at 8 is S
element bool open writable at 12
time U64 T

state Idle
step {
b0:
    %0 = const F64 1
    %1 = cvt bool %0
    store bool open, %1
    ret
}
machine "a"
vector "a" size 16 hash 0xb1dc9237

element U64 G at 0 is G
element U32 S at 8 is S
element bool open writable at 12
time U64 T

state Idle
step {
b0:
    %0 = const bool 1
    store bool open, %0
    ret
}
