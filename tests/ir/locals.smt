passes locals,dce,empty
# n is never stored: its initial value.  o is written from outside.  h is a name for what was stored, r is never read; k keeps its
# value from one block to another, and s is seen from outside.

-- ir --
machine "m"
vector "m" size 64 hash 0
element U64 G at 0 is G
element U32 S at 8 is S
element U16 u16 writable at 16
element F64 x writable at 24
element bool p writable at 32
local I8 n writable = -3
local I8 o outside = -4
local U16 h writable hidden = 0
local U16 r writable hidden = 0
local bool hb writable hidden = 0
local U16 k writable hidden = 0
local U16 s writable = 0
time U64 T

state A
entry {
b0:
    %0 = const U16 1
    store U16 r, %0
    ret
}
step {
b0:
    %0 = load I8 n
    %1 = load I8 o
    %2 = cvt U16 %0
    store U16 h, %2
    %3 = cvt U16 %1
    %4 = load U16 h
    store U16 u16, %4
    store U16 h, %3
    %5 = load U16 h
    store U16 k, %5
    store U16 s, %5
    %6 = load F64 x
    %7 = cvt bool %6
    store bool hb, %7
    %8 = load bool hb
    br %8, b1, b2
b1:
    %9 = load U16 k
    store U16 u16, %9
    store U16 r, %9
    ret
b2:
    %10 = load U16 s
    store U16 h, %10
    goto A
}
-- ir out --
machine "m"
vector "m" size 64 hash 0x00000000

element U64 G at 0 is G
element U32 S at 8 is S
element U16 u16 writable at 16
element F64 x writable at 24
element bool p writable at 32
local I8 n writable = -3
local I8 o outside = -4
local U16 k writable hidden = 0
local U16 s writable = 0
time U64 T

state A
step {
b0:
    %0 = const I8 -3
    %1 = load I8 o
    %2 = cvt U16 %0
    %3 = cvt U16 %1
    store U16 u16, %2
    store U16 k, %3
    store U16 s, %3
    %4 = load F64 x
    %5 = cvt bool %4
    br %5, b1, b2
b1:
    %6 = load U16 k
    store U16 u16, %6
    ret
b2:
    goto A
}
