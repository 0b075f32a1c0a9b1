passes identity,dce
# U8 to F64 to U8 changes nothing; U64 may round, another type may saturate.  F64 to F64 makes NaN 0 and stays where one can come.

-- ir --
state A
step {
b0:
    %0 = load U8 u8
    %1 = cvt F64 %0
    %2 = cvt U8 %1
    store U8 u8, %2
    %3 = load U64 u64
    %4 = cvt F64 %3
    %5 = cvt U64 %4
    store U64 u64, %5
    %6 = cvt U16 %1
    store U16 u16, %6
    %7 = load F32 f32
    %8 = cvt F64 %7
    %9 = cvt F32 %8
    store F32 f32, %9
    %10 = load F64 x
    %11 = cvt F64 %10
    store F64 y, %11
    %12 = add F64 %10, %10
    %13 = cvt F64 %12
    store F64 y, %13
    %14 = neg F64 %11
    %15 = cvt F64 %14
    store F64 y, %15
    %16 = load bool a
    %17 = cvt F64 %16
    %18 = cvt bool %17
    store bool flag, %18
    %19 = cvt F32 %10
    %20 = cvt F64 %19
    store F64 y, %20
    %21 = cvt F64 %20
    store F64 y, %21
    %22 = min F64 %10, %12
    %23 = cvt F64 %22
    store F64 y, %23
    %24 = max F64 %12, %10
    %25 = cvt F64 %24
    store F64 y, %25
    %26 = max F64 %10, %10
    %27 = cvt F64 %26
    store F64 y, %27
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load U8 u8
    %1 = cvt F64 %0
    store U8 u8, %0
    %2 = load U64 u64
    %3 = cvt F64 %2
    %4 = cvt U64 %3
    store U64 u64, %4
    %5 = cvt U16 %1
    store U16 u16, %5
    %6 = load F32 f32
    store F32 f32, %6
    %7 = load F64 x
    store F64 y, %7
    %8 = add F64 %7, %7
    %9 = cvt F64 %8
    store F64 y, %9
    %10 = neg F64 %7
    store F64 y, %10
    %11 = load bool a
    store bool flag, %11
    %12 = cvt F32 %7
    %13 = cvt F64 %12
    store F64 y, %13
    store F64 y, %13
    %14 = min F64 %7, %8
    %15 = cvt F64 %14
    store F64 y, %15
    %16 = max F64 %8, %7
    %17 = cvt F64 %16
    store F64 y, %17
    store F64 y, %7
    ret
}
