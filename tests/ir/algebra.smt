passes identity,dce
# Operations that become cheaper ones: signs, powers of two, conversions that truncate by themselves.

-- ir --
state A
step {
b0:
    %x = load F64 x
    %y = load F64 y
    %nx = neg F64 %x
    %ny = neg F64 %y
    %0 = add F64 %x, %ny
    %1 = sub F64 %0, %ny
    %2 = add F64 %nx, %1
    %3 = cvt F64 %2
    store F64 y, %3
    %4 = mul F64 %nx, %ny
    %5 = div F64 %4, %x
    %6 = div F64 %nx, %ny
    %7 = add F64 %5, %6
    %8 = cvt F64 %7
    store F64 y, %8
    %9 = const F64 -1
    %10 = mul F64 %x, %9
    %11 = abs F64 %10
    store F64 y, %11
    %12 = const F64 8
    %13 = div F64 %x, %12
    store F64 y, %13
    %14 = const F64 0x7fd0000000000000    # 2^1022: 2^-1022 is the smallest normal number
    %15 = div F64 %x, %14
    store F64 y, %15
    %16 = const F64 0x7fe0000000000000    # 2^1023: its reciprocal is subnormal
    %17 = div F64 %x, %16
    store F64 y, %17
    %18 = const F64 10
    %19 = div F64 %x, %18
    store F64 y, %19
    %20 = const F64 0
    %21 = div F64 %x, %20
    %22 = cvt F64 %21
    store F64 y, %22
    %23 = const F64 0x7ff0000000000000
    %24 = div F64 %x, %23
    %25 = cvt F64 %24
    store F64 y, %25
    %26 = trunc F64 %x
    %27 = cvt U8 %26
    store U8 u8, %27
    %28 = floor F64 %x
    %29 = cvt U16 %28
    store U16 u16, %29
    %30 = cvt bool %nx
    store bool flag, %30
    %31 = add F64 %x, %x
    %32 = cvt F64 %31
    %33 = cvt F32 %32
    store F32 f32, %33
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load F64 x
    %1 = load F64 y
    %2 = sub F64 %0, %1
    %3 = add F64 %2, %1
    %4 = sub F64 %3, %0
    %5 = cvt F64 %4
    store F64 y, %5
    %6 = mul F64 %0, %1
    %7 = div F64 %6, %0
    %8 = div F64 %0, %1
    %9 = add F64 %7, %8
    %10 = cvt F64 %9
    store F64 y, %10
    %11 = abs F64 %0
    store F64 y, %11
    %12 = const F64 0x3fc0000000000000  # 0.125
    %13 = mul F64 %0, %12
    store F64 y, %13
    %14 = const F64 0x0010000000000000  # 2.2250738585072014e-308
    %15 = mul F64 %0, %14
    store F64 y, %15
    %16 = const F64 0x7fe0000000000000  # 8.98846567431158e+307
    %17 = div F64 %0, %16
    store F64 y, %17
    %18 = const F64 10
    %19 = div F64 %0, %18
    store F64 y, %19
    %20 = const F64 0
    %21 = div F64 %0, %20
    %22 = cvt F64 %21
    store F64 y, %22
    %23 = const F64 0x7ff0000000000000  # inf
    %24 = div F64 %0, %23
    %25 = cvt F64 %24
    store F64 y, %25
    %26 = cvt U8 %0
    store U8 u8, %26
    %27 = floor F64 %0
    %28 = cvt U16 %27
    store U16 u16, %28
    %29 = cvt bool %0
    store bool flag, %29
    %30 = add F64 %0, %0
    %31 = cvt F32 %30
    store F32 f32, %31
    ret
}
