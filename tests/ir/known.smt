passes known,dce
# A guard that an earlier guard implies is decided; so is a comparison that the type decides, a local that is never written, T in
# .entry, and what a local can hold in a state.  min, abs, floor and a change of NaN to 0 go where they change nothing.

-- ir --
local I16 limit = 825
local I32 count writable = 0
local U8 mode writable = 1
state A
entry {
b0:
    %0 = load U64 T
    %1 = cvt F64 %0
    %2 = const F64 5
    %3 = lt F64 %1, %2
    %4 = cvt U8 %3
    store bool flag, %3
    ret
}
step {
b0:
    %0 = load F64 x
    %1 = const F64 10
    %2 = gt F64 %0, %1
    br %2, b1, b2
b1:
    %3 = load F64 x
    %4 = const F64 5
    %5 = gt F64 %3, %4
    store bool flag, %5
    %6 = load F64 x
    %7 = abs F64 %6
    %8 = cvt F64 %7
    store F64 y, %8
    jmp b3
b2:
    %9 = load U8 u8
    %10 = cvt F64 %9
    %11 = const F64 300
    %12 = le F64 %10, %11
    store bool flag, %12
    %13 = floor F64 %10
    %14 = min F64 %13, %11
    %15 = cvt F64 %14
    store F64 y, %15
    jmp b3
b3:
    %16 = load I16 limit
    %17 = cvt F64 %16
    %18 = load F64 y
    %19 = gt F64 %18, %17
    store bool flag, %19
    %20 = load U8 mode
    %21 = cvt F64 %20
    %22 = const F64 2
    %23 = le F64 %21, %22
    %24 = not %23
    store bool flag, %24
    %25 = const U8 2
    store U8 mode, %25
    goto B
}
state B
step {
b0:
    %0 = load I32 count
    %1 = cvt F64 %0
    %2 = const F64 100
    %3 = lt F64 %1, %2
    br %3, b1, b2
b1:
    %4 = load I32 count
    %5 = cvt F64 %4
    %6 = const F64 1
    %7 = add F64 %5, %6
    %8 = cvt I32 %7
    store I32 count, %8
    ret
b2:
    %9 = load I32 count
    %10 = cvt F64 %9
    %11 = const F64 100
    %12 = eq F64 %10, %11
    store bool flag, %12
    goto A
}
-- ir out --
local I16 limit = 825
local I32 count writable = 0
local U8 mode writable = 1

state A
entry {
b0:
    %0 = const bool 1
    store bool flag, %0
    ret
}
step {
b0:
    %0 = load F64 x
    %1 = const F64 10
    %2 = gt F64 %0, %1
    br %2, b1, b2
b1:
    %3 = const bool 1
    store bool flag, %3
    %4 = load F64 x
    store F64 y, %4
    jmp b3
b2:
    %5 = load U8 u8
    %6 = cvt F64 %5
    %7 = const bool 1
    store bool flag, %7
    store F64 y, %6
    jmp b3
b3:
    %8 = const F64 825
    %9 = load F64 y
    %10 = gt F64 %9, %8
    store bool flag, %10
    %11 = const bool 0
    store bool flag, %11
    %12 = const U8 2
    store U8 mode, %12
    goto B
}

state B
step {
b0:
    %0 = load I32 count
    %1 = cvt F64 %0
    %2 = const F64 100
    %3 = lt F64 %1, %2
    br %3, b1, b2
b1:
    %4 = load I32 count
    %5 = cvt F64 %4
    %6 = const F64 1
    %7 = add F64 %5, %6
    %8 = cvt I32 %7
    store I32 count, %8
    ret
b2:
    %9 = const bool 1
    store bool flag, %9
    goto A
}
