passes identity,dce
# not of a comparison, where no NaN comes; comparisons of a value with itself; bools held against numbers.

-- ir --
state A
step {
b0:
    %x = load F64 x
    %y = load F64 y
    %s = sqrt F64 %x
    %a = load bool a
    %0 = lt F64 %x, %y
    %1 = not %0
    store bool flag, %1
    %2 = ge F64 %x, %y
    %3 = not %2
    store bool flag, %3
    %4 = eq F64 %s, %y
    %5 = not %4
    store bool flag, %5
    %6 = le F64 %s, %y
    %7 = not %6
    store bool flag, %7
    %8 = lt F64 %s, %s
    store bool flag, %8
    %9 = le F64 %s, %s
    store bool flag, %9
    %10 = eq F64 %x, %x
    store bool flag, %10
    %11 = ne F64 %x, %x
    store bool flag, %11
    %12 = cvt F64 %a
    %13 = const F64 1
    %14 = eq F64 %12, %13
    store bool flag, %14
    %15 = ne F64 %13, %12
    store bool flag, %15
    %16 = const F64 2
    %17 = gt F64 %16, %12
    store bool flag, %17
    %18 = const F64 0x7ff8000000000000
    %19 = ne F64 %18, %12
    store bool flag, %19
    %20 = const F64 0
    %21 = gt F64 %12, %20
    store bool flag, %21
    %22 = const bool 0
    %23 = eq bool %a, %22
    store bool flag, %23
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load F64 x
    %1 = load F64 y
    %2 = sqrt F64 %0
    %3 = load bool a
    %4 = ge F64 %0, %1
    store bool flag, %4
    %5 = lt F64 %0, %1
    store bool flag, %5
    %6 = ne F64 %2, %1
    store bool flag, %6
    %7 = le F64 %2, %1
    %8 = not %7
    store bool flag, %8
    %9 = const bool 0
    store bool flag, %9
    %10 = le F64 %2, %2
    store bool flag, %10
    %11 = const bool 1
    store bool flag, %11
    %12 = const bool 0
    store bool flag, %12
    store bool flag, %3
    %13 = not %3
    store bool flag, %13
    %14 = const bool 1
    store bool flag, %14
    %15 = const bool 1
    store bool flag, %15
    store bool flag, %3
    %16 = not %3
    store bool flag, %16
    ret
}
