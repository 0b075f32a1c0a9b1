passes identity,dce
# Operations that become cheaper ones: signs, conversions that truncate by themselves.  Quotients stay: 8 is a shorter operand than 0.125.

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
    %12 = const F64 8
    %13 = div F64 %0, %12
    store F64 y, %13
    %14 = const F64 10
    %15 = div F64 %0, %14
    store F64 y, %15
    %16 = const F64 0
    %17 = div F64 %0, %16
    %18 = cvt F64 %17
    store F64 y, %18
    %19 = const F64 0x7ff0000000000000  # inf
    %20 = div F64 %0, %19
    %21 = cvt F64 %20
    store F64 y, %21
    %22 = cvt U8 %0
    store U8 u8, %22
    %23 = floor F64 %0
    %24 = cvt U16 %23
    store U16 u16, %24
    %25 = cvt bool %0
    store bool flag, %25
    %26 = add F64 %0, %0
    %27 = cvt F32 %26
    store F32 f32, %27
    ret
}
