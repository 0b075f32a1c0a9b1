passes fold,dce
# Operations and comparisons on numbers of other types than F64 give those types.

-- ir --
state A
step {
b0:
    %0 = const I32 7
    %1 = const I32 -9
    %2 = add I32 %0, %1
    store I32 i32, %2
    %3 = mul I32 %0, %1
    store I32 i32, %3
    %4 = lt I32 %1, %0
    store bool flag, %4
    %5 = const I64 4611686018427387904
    %6 = const I64 4611686018427387905
    %7 = eq I64 %5, %6                  # equal as F64, which is what comparisons mean
    store bool flag, %7
    %8 = const F32 0x3fc00000           # 1.5
    %9 = const F32 0x40000000           # 2
    %10 = div F32 %8, %9
    %11 = cvt F32 %10
    store F32 f32, %11
    %12 = neg I64 %6
    store I64 i64, %12
    ret
}
-- ir out --
state A
step {
b0:
    %0 = const I32 -2
    store I32 i32, %0
    %1 = const I32 -63
    store I32 i32, %1
    %2 = const bool 1
    store bool flag, %2
    %3 = const bool 1
    store bool flag, %3
    %4 = const F32 0x3f400000  # 0.75
    store F32 f32, %4
    %5 = const I64 -4611686018427387904
    store I64 i64, %5
    ret
}
