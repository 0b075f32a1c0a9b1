passes narrow,dce
# A result of an F32 operation is rounded where it is read as an F32. So the conversion to F32 stays where an F64 is made of it, and
# where the next F32 operation reads it: a machine that computes F32 operations as F64 rounds only there.

-- ir --
machine "m"
vector "m" size 64 hash 0
element U64 G at 0 is G
element U32 S at 8 is S
element F32 x writable at 16
element F64 y writable at 24
element F64 z writable at 32
time U64 T

state A
step {
b0:
    %0 = load F32 x
    %1 = cvt F64 %0
    %2 = const F64 0x4059000000000000
    %3 = sub F64 %1, %2
    %4 = cvt F32 %3
    %5 = cvt F64 %4
    store F64 y, %5
    %6 = mul F64 %5, %5
    %7 = cvt F32 %6
    %8 = cvt F64 %7
    store F64 z, %8
    ret
}
-- ir out --
machine "m"
vector "m" size 64 hash 0x00000000

element U64 G at 0 is G
element U32 S at 8 is S
element F32 x writable at 16
element F64 y writable at 24
element F64 z writable at 32
time U64 T

state A
step {
b0:
    %0 = load F32 x
    %1 = const F32 100
    %2 = sub F32 %0, %1
    %3 = cvt F32 %2
    %4 = cvt F64 %3
    store F64 y, %4
    %5 = mul F32 %3, %3
    %6 = cvt F32 %5
    %7 = cvt F64 %6
    store F64 z, %7
    ret
}
