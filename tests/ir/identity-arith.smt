passes identity,dce
# What leaves every number as it is, -0, infinities and NaN included.  x + 0 is not among it (-0 + 0 is 0), but n + 0 is.

-- ir --
state A
step {
b0:
    %x = load F64 x
    %0 = const F64 0
    %1 = const F64 1
    %m0 = const F64 0x8000000000000000
    %nan = const F64 0x7ff8000000000000
    %2 = mul F64 %x, %1
    %3 = mul F64 %1, %2
    %4 = div F64 %3, %1
    %5 = sub F64 %4, %0
    %6 = add F64 %5, %m0
    %7 = add F64 %m0, %6
    %8 = neg F64 %7
    %9 = neg F64 %8
    %10 = min F64 %9, %7
    %11 = max F64 %10, %x
    store F64 y, %11
    %12 = add F64 %x, %0
    %13 = cvt F64 %12
    store F64 y, %13
    %14 = sub F64 %x, %m0
    %15 = cvt F64 %14
    store F64 y, %15
    %16 = div F64 %1, %x
    %17 = cvt F64 %16
    store F64 y, %17
    %18 = sub F64 %0, %x
    %19 = cvt F64 %18
    store F64 y, %19
    %20 = sub F64 %x, %nan
    %21 = cvt F64 %20
    store F64 y, %21
    %n = load U8 u8
    %22 = cvt F64 %n
    %23 = add F64 %22, %0
    %24 = add F64 %0, %23
    %25 = floor F64 %24
    %26 = cvt U16 %25
    store U16 u16, %26
    %27 = abs F64 %x
    %28 = add F64 %27, %0
    %29 = abs F64 %28
    %30 = ceil F64 %29
    %31 = round F64 %30
    store F64 y, %31
    %32 = sqrt F64 %x
    %33 = floor F64 %32
    %34 = cvt F64 %33
    store F64 y, %34
    %35 = load I32 i32
    %36 = const I32 0
    %37 = const I32 1
    %38 = add I32 %35, %36
    %39 = sub I32 %38, %36
    %40 = mul I32 %37, %39
    store I32 i32, %40
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load F64 x
    %1 = const F64 0
    %2 = const F64 1
    %3 = const F64 0x8000000000000000  # -0
    %4 = const F64 0x7ff8000000000000  # nan
    store F64 y, %0
    %5 = add F64 %0, %1
    %6 = cvt F64 %5
    store F64 y, %6
    %7 = sub F64 %0, %3
    %8 = cvt F64 %7
    store F64 y, %8
    %9 = div F64 %2, %0
    %10 = cvt F64 %9
    store F64 y, %10
    %11 = sub F64 %1, %0
    %12 = cvt F64 %11
    store F64 y, %12
    %13 = sub F64 %0, %4
    %14 = cvt F64 %13
    store F64 y, %14
    %15 = load U8 u8
    %16 = cvt F64 %15
    %17 = cvt U16 %16
    store U16 u16, %17
    %18 = abs F64 %0
    %19 = ceil F64 %18
    store F64 y, %19
    %20 = sqrt F64 %0
    %21 = floor F64 %20
    %22 = cvt F64 %21
    store F64 y, %22
    %23 = load I32 i32
    store I32 i32, %23
    ret
}
