passes narrow,dce
# An I64 or U64 that a conversion has written converts to F64 and back without a change, so it is compared, moved and measured as an
# integer.  Not if it was not written here, and not a U64 beside an I64: 2^63 - 1 and 2^63 convert to the same F64.

-- ir --
state A
step {
b0:
    %0 = load I64 i64
    %1 = cvt F64 %0
    %2 = load F64 x
    %3 = cvt I64 %2
    %4 = cvt F64 %3
    %5 = lt F64 %4, %1
    store bool flag, %5
    store I64 i64, %3
    %6 = load I64 i64
    %7 = cvt F64 %6
    %8 = abs F64 %7
    %9 = lt F64 %8, %4
    store bool flag, %9
    %10 = cvt U64 %8
    store U64 u64, %10
    %11 = max F64 %7, %8
    %12 = cvt I64 %11
    store I64 i64, %12
    %13 = cvt U64 %2
    %14 = cvt F64 %13
    %15 = eq F64 %14, %4
    store bool flag, %15
    %16 = cvt I64 %14
    store I64 i64, %16
    %17 = load U64 u64
    %18 = cvt F64 %17
    %19 = ge F64 %18, %14
    store bool flag, %19
    %20 = const I64 9007199254740993
    %21 = cvt F64 %20
    %22 = gt F64 %21, %4
    store bool flag, %22
    %23 = const I64 9007199254740994
    %24 = cvt F64 %23
    %25 = gt F64 %24, %4
    store bool flag, %25
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load I64 i64
    %1 = cvt F64 %0
    %2 = load F64 x
    %3 = cvt I64 %2
    %4 = cvt F64 %3
    %5 = lt F64 %4, %1
    store bool flag, %5
    store I64 i64, %3
    %6 = load I64 i64
    %7 = abs I64 %6
    %8 = cvt F64 %7
    %9 = lt I64 %7, %3
    store bool flag, %9
    %10 = cvt U64 %8
    store U64 u64, %10
    %11 = max I64 %6, %7
    store I64 i64, %11
    %12 = cvt U64 %2
    %13 = cvt F64 %12
    %14 = eq F64 %13, %4
    store bool flag, %14
    %15 = cvt I64 %13
    store I64 i64, %15
    %16 = load U64 u64
    %17 = ge U64 %16, %12
    store bool flag, %17
    %18 = const I64 9007199254740993
    %19 = cvt F64 %18
    %20 = gt F64 %19, %4
    store bool flag, %20
    %21 = const I64 9007199254740994
    %22 = gt I64 %21, %3
    store bool flag, %22
    ret
}
