passes if_convert,dce
# Conditionals that stay: an element is stored in one arm alone or counted; a local that a script writes; a count by two, one minus the
# local, and an arm that stores what the other counts; arms that end elsewhere; an arm into which another edge leads.

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

state Elements
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = const bool 1
    store bool flag, %1
    jmp b2
b2:
    %2 = load bool b
    br %2, b3, b4
b3:
    %3 = load U32 u32
    %4 = cvt I64 %3
    %5 = const I64 1
    %6 = add I64 %4, %5
    %7 = cvt U32 %6
    store U32 u32, %7
    ret
b4:
    ret
}

state Others
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = load U8 script
    %2 = cvt I32 %1
    %3 = const I32 1
    %4 = add I32 %2, %3
    %5 = cvt U8 %4
    store U8 script, %5
    jmp b2
b2:
    %6 = load bool b
    br %6, b3, b4
b3:
    %7 = load U8 n
    %8 = cvt I32 %7
    %9 = const I32 2
    %10 = add I32 %8, %9
    %11 = cvt U8 %10
    store U8 n, %11
    jmp b4
b4:
    %12 = load bool a
    br %12, b5, b6
b5:
    %13 = load U8 n
    %14 = cvt I32 %13
    %15 = const I32 1
    %16 = sub I32 %15, %14
    %17 = cvt U8 %16
    store U8 n, %17
    jmp b6
b6:
    %18 = load bool b
    br %18, b7, b8
b7:
    %19 = load U8 n
    %20 = cvt I32 %19
    %21 = const I32 1
    %22 = add I32 %20, %21
    %23 = cvt U8 %22
    store U8 n, %23
    ret
b8:
    %24 = const U8 0
    store U8 n, %24
    ret
}

state Paths
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = const bool 1
    store bool flag, %1
    goto Truths
b2:
    %2 = const bool 0
    store bool flag, %2
    ret
}
exit {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = load bool b
    br %1, b3, b4
b2:
    %2 = const bool 1
    store bool flag, %2
    jmp b3
b3:
    %3 = const bool 0
    store bool flag, %3
    ret
b4:
    %4 = const bool 1
    store bool flag, %4
    ret
}

state Truths
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = const bool 1
    store bool flag, %1
    ret
b2:
    %2 = const bool 0
    store bool flag, %2
    jmp b3
b3:
    %3 = const U32 7
    store U32 u32, %3
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

state Elements
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = const bool 1
    store bool flag, %1
    jmp b2
b2:
    %2 = load bool b
    br %2, b3, b4
b3:
    %3 = load U32 u32
    %4 = cvt I64 %3
    %5 = const I64 1
    %6 = add I64 %4, %5
    %7 = cvt U32 %6
    store U32 u32, %7
    ret
b4:
    ret
}

state Others
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = load U8 script
    %2 = cvt I32 %1
    %3 = const I32 1
    %4 = add I32 %2, %3
    %5 = cvt U8 %4
    store U8 script, %5
    jmp b2
b2:
    %6 = load bool b
    br %6, b3, b4
b3:
    %7 = load U8 n
    %8 = cvt I32 %7
    %9 = const I32 2
    %10 = add I32 %8, %9
    %11 = cvt U8 %10
    store U8 n, %11
    jmp b4
b4:
    %12 = load bool a
    br %12, b5, b6
b5:
    %13 = load U8 n
    %14 = cvt I32 %13
    %15 = const I32 1
    %16 = sub I32 %15, %14
    %17 = cvt U8 %16
    store U8 n, %17
    jmp b6
b6:
    %18 = load bool b
    br %18, b7, b8
b7:
    %19 = load U8 n
    %20 = cvt I32 %19
    %21 = const I32 1
    %22 = add I32 %20, %21
    %23 = cvt U8 %22
    store U8 n, %23
    ret
b8:
    %24 = const U8 0
    store U8 n, %24
    ret
}

state Paths
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = const bool 1
    store bool flag, %1
    goto Truths
b2:
    %2 = const bool 0
    store bool flag, %2
    ret
}
exit {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = load bool b
    br %1, b3, b4
b2:
    %2 = const bool 1
    store bool flag, %2
    jmp b3
b3:
    %3 = const bool 0
    store bool flag, %3
    ret
b4:
    %4 = const bool 1
    store bool flag, %4
    ret
}

state Truths
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = const bool 1
    store bool flag, %1
    ret
b2:
    %2 = const bool 0
    store bool flag, %2
    jmp b3
b3:
    %3 = const U32 7
    store U32 u32, %3
    ret
}
