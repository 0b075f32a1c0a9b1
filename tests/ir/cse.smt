passes cse,dce
# Repeated loads, constants and operations; operands in either order; a > b is b < a.

-- ir --
state A
step {
b0:
    %0 = load F64 x
    %1 = load F64 y
    %2 = add F64 %0, %1
    %3 = load F64 y
    %4 = load F64 x
    %5 = add F64 %3, %4
    %6 = sub F64 %0, %1
    %7 = sub F64 %1, %0
    %8 = mul F64 %2, %6
    %9 = mul F64 %5, %7
    %10 = div F64 %8, %9
    %11 = cvt F64 %10
    store F64 x, %11
    %12 = gt F64 %2, %6
    %13 = lt F64 %6, %5
    %14 = ge F64 %2, %6
    %15 = and %12, %14
    %16 = and %13, %15
    %17 = const F64 1
    %18 = const F64 1
    %19 = const U8 1
    %20 = cvt F64 %16
    %21 = add F64 %20, %17
    %22 = add F64 %21, %18
    %23 = cvt F64 %22
    store F64 y, %23
    store U8 u8, %19
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load F64 x
    %1 = load F64 y
    %2 = add F64 %0, %1
    %3 = sub F64 %0, %1
    %4 = sub F64 %1, %0
    %5 = mul F64 %2, %3
    %6 = mul F64 %2, %4
    %7 = div F64 %5, %6
    %8 = cvt F64 %7
    store F64 x, %8
    %9 = gt F64 %2, %3
    %10 = ge F64 %2, %3
    %11 = and %9, %10
    %12 = and %9, %11
    %13 = const F64 1
    %14 = const U8 1
    %15 = cvt F64 %12
    %16 = add F64 %15, %13
    %17 = add F64 %16, %13
    %18 = cvt F64 %17
    store F64 y, %18
    store U8 u8, %14
    ret
}
