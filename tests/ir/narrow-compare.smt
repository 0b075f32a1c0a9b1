passes narrow,dce
# Comparisons in the type that the numbers come in: constants move to the next number the type has, truths are themselves or their
# opposite, 64-bit integers keep their order to constants below 2^53 only.

-- ir --
state A
step {
b0:
    %0 = load U8 u8
    %1 = cvt F64 %0
    %2 = const F64 0x4004000000000000
    %3 = lt F64 %1, %2
    store bool flag, %3
    %4 = ge F64 %1, %2
    store bool flag, %4
    %5 = lt F64 %2, %1
    store bool flag, %5
    %6 = load F32 f32
    %7 = cvt F64 %6
    %8 = const F64 0x3fb999999999999a
    %9 = lt F64 %7, %8
    store bool flag, %9
    %10 = gt F64 %7, %8
    store bool flag, %10
    %11 = load bool a
    %12 = cvt F64 %11
    %13 = const F64 1
    %14 = eq F64 %12, %13
    store bool flag, %14
    %15 = lt F64 %12, %13
    store bool flag, %15
    %16 = load U64 T
    %17 = cvt F64 %16
    %18 = const F64 9007199254740991
    %19 = gt F64 %17, %18
    store bool flag, %19
    %20 = const F64 9007199254740992
    %21 = gt F64 %17, %20
    store bool flag, %21
    %22 = load I16 i16
    %23 = cvt F64 %22
    %24 = gt F64 %1, %23
    store bool flag, %24
    %25 = load U32 u32
    %26 = cvt F64 %25
    %27 = eq F64 %23, %26
    store bool flag, %27
    %28 = load U64 u64
    %29 = cvt F64 %28
    %30 = eq F64 %29, %17
    store bool flag, %30
    %31 = abs F64 %7
    %32 = const F64 5
    %33 = lt F64 %31, %32
    store bool flag, %33
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load U8 u8
    %1 = const U8 2
    %2 = le U8 %0, %1
    store bool flag, %2
    %3 = const U8 2
    %4 = gt U8 %0, %3
    store bool flag, %4
    %5 = const U8 2
    %6 = gt U8 %0, %5
    store bool flag, %6
    %7 = load F32 f32
    %8 = const F32 0x3dcccccc  # 0.099999994
    %9 = le F32 %7, %8
    store bool flag, %9
    %10 = const F32 0x3dcccccc  # 0.099999994
    %11 = gt F32 %7, %10
    store bool flag, %11
    %12 = load bool a
    store bool flag, %12
    %13 = not %12
    store bool flag, %13
    %14 = load U64 T
    %15 = cvt F64 %14
    %16 = const U64 9007199254740991
    %17 = gt U64 %14, %16
    store bool flag, %17
    %18 = const F64 0x4340000000000000  # 9007199254740992
    %19 = gt F64 %15, %18
    store bool flag, %19
    %20 = load I16 i16
    %21 = cvt I32 %0
    %22 = cvt I32 %20
    %23 = gt I32 %21, %22
    store bool flag, %23
    %24 = load U32 u32
    %25 = cvt I64 %20
    %26 = cvt I64 %24
    %27 = eq I64 %25, %26
    store bool flag, %27
    %28 = load U64 u64
    %29 = cvt F64 %28
    %30 = eq F64 %29, %15
    store bool flag, %30
    %31 = abs F32 %7
    %32 = const F32 5
    %33 = lt F32 %31, %32
    store bool flag, %33
    ret
}
