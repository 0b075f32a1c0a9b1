passes locals,dce
# Of an F32 operation only the F32 may be asked for, so a local that holds it is not a mere name for it.

-- ir --
machine "m"
vector "m" size 64 hash 0
element U64 G at 0 is G
element U32 S at 8 is S
element F32 x writable at 16
element F64 y writable at 24
local F32 f writable hidden = 0
local F32 g writable hidden = 0
time U64 T

state A
step {
b0:
    %0 = load F32 x
    %1 = add F32 %0, %0
    store F32 f, %1
    store F32 g, %0
    %2 = load F32 f
    %3 = cvt F64 %2
    store F64 y, %3
    %4 = load F32 g
    store F32 x, %4
    ret
}
-- ir out --
machine "m"
vector "m" size 64 hash 0x00000000

element U64 G at 0 is G
element U32 S at 8 is S
element F32 x writable at 16
element F64 y writable at 24
local F32 f writable hidden = 0
local F32 g writable hidden = 0
time U64 T

state A
step {
b0:
    %0 = load F32 x
    %1 = add F32 %0, %0
    store F32 f, %1
    %2 = load F32 f
    %3 = cvt F64 %2
    store F64 y, %3
    store F32 x, %0
    ret
}
