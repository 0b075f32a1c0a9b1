passes identity
# On F64, where the VM computes it, this product may be -0 and the sum with 0 is not; an integer that was only loaded is no -0.

-- ir --
state A
step {
b0:
    %0 = load I32 i32
    %1 = load I16 i16
    %2 = cvt I64 %0
    %3 = cvt I64 %1
    %4 = mul I64 %2, %3
    %5 = const I64 0
    %6 = add I64 %5, %4
    %7 = cvt F32 %6
    store F32 f32, %7
    %8 = load U8 u8
    %9 = cvt F64 %8
    %10 = const F64 0
    %11 = add F64 %9, %10
    %12 = cvt F64 %11
    store F64 x, %12
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load I32 i32
    %1 = load I16 i16
    %2 = cvt I64 %0
    %3 = cvt I64 %1
    %4 = mul I64 %2, %3
    %5 = const I64 0
    %6 = add I64 %5, %4
    %7 = cvt F32 %6
    store F32 f32, %7
    %8 = load U8 u8
    %9 = cvt F64 %8
    %10 = const F64 0
    %11 = add F64 %9, %10
    %12 = cvt F64 %9
    store F64 x, %9
    ret
}
