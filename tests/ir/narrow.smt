passes narrow,dce
# Whole numbers that stay within 2^53 are added and multiplied as integers, in 32 bits where those hold all of it; not where
# -0 and 0 could be distinguished.  F32 with F32 to F32 is F32 work.

-- ir --
state A
step {
b0:
    %0 = load U8 u8
    %1 = cvt F64 %0
    %2 = load I16 i16
    %3 = cvt F64 %2
    %4 = mul F64 %1, %3
    %5 = const F64 3
    %6 = sub F64 %4, %5
    %7 = cvt U16 %6
    store U16 u16, %7
    %8 = load U32 u32
    %9 = cvt F64 %8
    %10 = add F64 %9, %3
    %11 = cvt F64 %10
    store F64 x, %11
    %12 = mul F64 %1, %3
    %13 = cvt F64 %12
    store F64 y, %13
    %14 = load F32 f32
    %15 = cvt F64 %14
    %16 = const F64 0x3fe0000000000000
    %17 = mul F64 %15, %16
    %18 = cvt F32 %17
    store F32 f32, %18
    %19 = const F64 0x3fb999999999999a
    %20 = mul F64 %15, %19
    %21 = cvt F32 %20
    store F32 f32, %21
    %22 = load U64 u64
    %23 = cvt F64 %22
    %24 = const F64 1
    %25 = add F64 %23, %24
    %26 = cvt U64 %25
    store U64 u64, %26
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load U8 u8
    %1 = cvt F64 %0
    %2 = load I16 i16
    %3 = cvt F64 %2
    %4 = cvt I32 %0
    %5 = cvt I32 %2
    %6 = mul I32 %4, %5
    %7 = const I32 3
    %8 = sub I32 %6, %7
    %9 = cvt U16 %8
    store U16 u16, %9
    %10 = load U32 u32
    %11 = cvt I64 %10
    %12 = cvt I64 %2
    %13 = add I64 %11, %12
    %14 = cvt F64 %13
    store F64 x, %14
    %15 = mul F64 %1, %3
    %16 = cvt F64 %15
    store F64 y, %16
    %17 = load F32 f32
    %18 = cvt F64 %17
    %19 = const F32 0x3f000000  # 0.5
    %20 = mul F32 %17, %19
    %21 = cvt F32 %20
    store F32 f32, %21
    %22 = const F64 0x3fb999999999999a  # 0.1
    %23 = mul F64 %18, %22
    %24 = cvt F32 %23
    store F32 f32, %24
    %25 = load U64 u64
    %26 = cvt F64 %25
    %27 = const F64 1
    %28 = add F64 %26, %27
    %29 = cvt U64 %28
    store U64 u64, %29
    ret
}
