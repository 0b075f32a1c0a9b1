passes windows
# A window keeps its samples in the type that they have before they become F64: but for I64 and U64, which F64 rounds.  One that has
# a type already keeps it, and so does one whose sample is computed; a conversion that something else uses stays.

-- ir --
window w0 F64 size 3 stats min
window w1 F64 size 3 stats min
window w2 F64 size 3 stats min
window w3 F64 size 3 stats min
window w4 F64 size 3 stats min
window w5 F64 size 3 stats min
window w6 F64 size 3 stats min
window w7 F64 size 3 stats min
window w8 F64 size 3 stats min
window w9 I8 size 3 stats min
window w10 F64 size 3 stats min
window w11 F64 size 3 stats min
sample {
b0:
    %0 = load I8 i8
    %1 = cvt F64 %0
    sample w0, %1
    %2 = load U16 u16
    %3 = cvt F64 %2
    sample w1, %3
    %4 = load I32 i32
    %5 = cvt F64 %4
    sample w2, %5
    %6 = load U32 u32
    %7 = cvt F64 %6
    sample w3, %7
    %8 = load F32 f32
    %9 = cvt F64 %8
    sample w4, %9
    %10 = load bool flag
    %11 = cvt F64 %10
    sample w5, %11
    %12 = load I64 i64
    %13 = cvt F64 %12
    sample w6, %13
    %14 = load U64 u64
    %15 = cvt F64 %14
    sample w7, %15
    %16 = load F64 x
    sample w8, %16
    sample w9, %3
    %17 = load I16 i16
    %18 = cvt F64 %17
    %19 = add F64 %18, %18
    sample w10, %19
    sample w11, %18
    ret
}
state A
step {
b0:
    %0 = stat min w0
    %1 = cvt F64 %0
    store F64 x, %1
    %2 = stat min w1
    %3 = cvt F64 %2
    store F64 x, %3
    %4 = stat min w2
    %5 = cvt F64 %4
    store F64 x, %5
    %6 = stat min w3
    %7 = cvt F64 %6
    store F64 x, %7
    %8 = stat min w4
    %9 = cvt F64 %8
    store F64 x, %9
    %10 = stat min w5
    %11 = cvt F64 %10
    store F64 x, %11
    %12 = stat min w6
    %13 = cvt F64 %12
    store F64 x, %13
    %14 = stat min w7
    %15 = cvt F64 %14
    store F64 x, %15
    %16 = stat min w8
    %17 = cvt F64 %16
    store F64 x, %17
    %18 = stat min w9
    %19 = cvt F64 %18
    store F64 x, %19
    %20 = stat min w10
    %21 = cvt F64 %20
    store F64 x, %21
    %22 = stat min w11
    %23 = cvt F64 %22
    store F64 x, %23
    ret
}
-- ir out --
window w0 I8 size 3 stats min
window w1 U16 size 3 stats min
window w2 I32 size 3 stats min
window w3 U32 size 3 stats min
window w4 F32 size 3 stats min
window w5 bool size 3 stats min
window w6 F64 size 3 stats min
window w7 F64 size 3 stats min
window w8 F64 size 3 stats min
window w9 I8 size 3 stats min
window w10 F64 size 3 stats min
window w11 I16 size 3 stats min

sample {
b0:
    %0 = load I8 i8
    sample w0, %0
    %1 = load U16 u16
    sample w1, %1
    %2 = load I32 i32
    sample w2, %2
    %3 = load U32 u32
    sample w3, %3
    %4 = load F32 f32
    sample w4, %4
    %5 = load bool flag
    sample w5, %5
    %6 = load I64 i64
    %7 = cvt F64 %6
    sample w6, %7
    %8 = load U64 u64
    %9 = cvt F64 %8
    sample w7, %9
    %10 = load F64 x
    sample w8, %10
    sample w9, %1
    %11 = load I16 i16
    %12 = cvt F64 %11
    %13 = add F64 %12, %12
    sample w10, %13
    sample w11, %11
    ret
}

state A
step {
b0:
    %0 = stat min w0
    %1 = cvt F64 %0
    store F64 x, %1
    %2 = stat min w1
    %3 = cvt F64 %2
    store F64 x, %3
    %4 = stat min w2
    %5 = cvt F64 %4
    store F64 x, %5
    %6 = stat min w3
    %7 = cvt F64 %6
    store F64 x, %7
    %8 = stat min w4
    %9 = cvt F64 %8
    store F64 x, %9
    %10 = stat min w5
    %11 = cvt F64 %10
    store F64 x, %11
    %12 = stat min w6
    %13 = cvt F64 %12
    store F64 x, %13
    %14 = stat min w7
    %15 = cvt F64 %14
    store F64 x, %15
    %16 = stat min w8
    %17 = cvt F64 %16
    store F64 x, %17
    %18 = stat min w9
    %19 = cvt F64 %18
    store F64 x, %19
    %20 = stat min w10
    %21 = cvt F64 %20
    store F64 x, %21
    %22 = stat min w11
    %23 = cvt F64 %22
    store F64 x, %23
    ret
}
