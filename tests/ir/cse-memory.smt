passes cse,dce
# A load after a store has the stored value, though it stays a load: its users find that its root is known. A constant takes its place.
# A store of what was stored in this block already is dropped; one of what was merely read is not: that it was stored is seen.
# With a local it is dropped, unless others write it.

-- ir --
machine "m"
vector "m" size 64 hash 0
element U64 G at 0 is G
element U32 S at 8 is S
element U16 u16 writable at 16
element F64 x writable at 24
element F64 y writable at 32
element F64 z writable at 40
local I8 n writable = 0
local I8 o writable outside = 0
time U64 T

state A
step {
b0:
    %0 = load F64 x
    %1 = mul F64 %0, %0
    %2 = cvt F64 %1
    store F64 y, %2
    %3 = load F64 y
    store F64 y, %3
    %4 = load F64 z
    store F64 z, %4
    %5 = sqrt F64 %3
    %6 = sqrt F64 %2
    %7 = add F64 %5, %6
    %8 = cvt F64 %7
    store F64 x, %8
    %9 = load F64 x
    %10 = mul F64 %9, %9
    %11 = cvt F64 %10
    store F64 z, %11
    %12 = const U16 7
    store U16 u16, %12
    %13 = load U16 u16
    store U16 u16, %13
    %14 = load I8 n
    store I8 n, %14
    %15 = load I8 o
    store I8 o, %15
    ret
}
-- ir out --
machine "m"
vector "m" size 64 hash 0x00000000

element U64 G at 0 is G
element U32 S at 8 is S
element U16 u16 writable at 16
element F64 x writable at 24
element F64 y writable at 32
element F64 z writable at 40
local I8 n writable = 0
local I8 o writable outside = 0
time U64 T

state A
step {
b0:
    %0 = load F64 x
    %1 = mul F64 %0, %0
    %2 = cvt F64 %1
    store F64 y, %2
    %3 = load F64 y
    %4 = load F64 z
    store F64 z, %4
    %5 = sqrt F64 %3
    %6 = add F64 %5, %5
    %7 = cvt F64 %6
    store F64 x, %7
    %8 = load F64 x
    %9 = mul F64 %8, %8
    %10 = cvt F64 %9
    store F64 z, %10
    %11 = const U16 7
    store U16 u16, %11
    %12 = load I8 o
    store I8 o, %12
    ret
}
