passes if_convert,dce
soft
# With numbers in software a count stays a branch; a boolean does not.

-- ir --
machine "m"
vector "m" size 64 hash 0
element U64 G at 0 is G
element U32 S at 8 is S
element U32 u32 writable at 16
element bool flag writable at 20
element bool a at 21
element bool b at 22
local U8 n writable = 0
local I64 big writable = 0
local U16 down writable = 9
local U8 script writable outside = 0
time U64 T

state Truths
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = const bool 1
    store bool flag, %1
    jmp b3
b2:
    %2 = const bool 0
    store bool flag, %2
    jmp b3
b3:
    %3 = load bool b
    br %3, b4, b5
b4:
    %4 = const bool 0
    store bool flag, %4
    ret
b5:
    %5 = const bool 1
    store bool flag, %5
    ret
}
exit {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = const bool 1
    store bool flag, %1
    ret
b2:
    %2 = const bool 1
    store bool flag, %2
    ret
}

state Counts
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = load U8 n
    %2 = cvt I32 %1
    %3 = const I32 1
    %4 = add I32 %2, %3
    %5 = cvt U8 %4
    store U8 n, %5
    jmp b3
b2:
    %6 = load I64 big
    %7 = cvt F64 %6
    %8 = const F64 1
    %9 = sub F64 %7, %8
    %10 = cvt I64 %9
    store I64 big, %10
    jmp b3
b3:
    %11 = load bool b
    br %11, b4, b5
b4:
    %12 = const I32 1
    %13 = load U16 down
    %14 = cvt I32 %13
    %15 = add I32 %12, %14
    %16 = cvt U16 %15
    store U16 down, %16
    jmp b5
b5:
    ret
}
-- ir out --
machine "m"
vector "m" size 64 hash 0x00000000

element U64 G at 0 is G
element U32 S at 8 is S
element U32 u32 writable at 16
element bool flag writable at 20
element bool a at 21
element bool b at 22
local U8 n writable = 0
local I64 big writable = 0
local U16 down writable = 9
local U8 script writable outside = 0
time U64 T

state Truths
step {
b0:
    %0 = load bool a
    store bool flag, %0
    jmp b3
b1:
    jmp b3
b2:
    jmp b3
b3:
    %1 = load bool b
    %2 = not %1
    store bool flag, %2
    ret
b4:
    ret
b5:
    ret
}
exit {
b0:
    %0 = const bool 1
    store bool flag, %0
    ret
b1:
    ret
b2:
    ret
}

state Counts
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = load U8 n
    %2 = cvt I32 %1
    %3 = const I32 1
    %4 = add I32 %2, %3
    %5 = cvt U8 %4
    store U8 n, %5
    jmp b3
b2:
    %6 = load I64 big
    %7 = cvt F64 %6
    %8 = const F64 1
    %9 = sub F64 %7, %8
    %10 = cvt I64 %9
    store I64 big, %10
    jmp b3
b3:
    %11 = load bool b
    br %11, b4, b5
b4:
    %12 = const I32 1
    %13 = load U16 down
    %14 = cvt I32 %13
    %15 = add I32 %12, %14
    %16 = cvt U16 %15
    store U16 down, %16
    jmp b5
b5:
    ret
}
