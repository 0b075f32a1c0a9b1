passes fold
# Every operation that can be computed, at the places where it is easiest to get wrong.

-- ir --
state A
step {
b0:
    %one = const F64 1
    %two = const F64 2
    %zero = const F64 0
    %minus0 = const F64 0x8000000000000000
    %inf = const F64 0x7ff0000000000000
    %half = const F64 0x3fe0000000000000
    %t = const bool 1
    %f = const bool 0
    %tenth = const F64 0x3fb999999999999a
    %0 = add F64 %tenth, %tenth
    %1 = sub F64 %one, %tenth
    %2 = mul F64 %two, %minus0
    %3 = div F64 %one, %minus0
    %4 = div F64 %zero, %zero
    %5 = sub F64 %inf, %inf
    %6 = neg F64 %zero
    %7 = neg F64 %4
    %8 = abs F64 %minus0
    %9 = floor F64 %half
    %10 = ceil F64 %half
    %minus_half = neg F64 %half
    %11 = trunc F64 %minus_half
    %12 = round F64 %half
    %13 = sqrt F64 %two
    %14 = sqrt F64 %minus_half
    %15 = sign F64 %minus_half
    %16 = min F64 %zero, %minus0
    %17 = max F64 %minus0, %zero
    %18 = min F64 %4, %one
    %19 = eq F64 %zero, %minus0
    %20 = ne F64 %4, %4
    %21 = lt F64 %4, %one
    %22 = le F64 %one, %one
    %23 = gt F64 %one, %two
    %24 = ge F64 %4, %4
    %25 = and %t, %f
    %26 = or %t, %f
    %27 = not %f
    ret
}
-- ir out --
state A
step {
b0:
    %0 = const F64 1
    %1 = const F64 2
    %2 = const F64 0
    %3 = const F64 0x8000000000000000  # -0
    %4 = const F64 0x7ff0000000000000  # inf
    %5 = const F64 0x3fe0000000000000  # 0.5
    %6 = const bool 1
    %7 = const bool 0
    %8 = const F64 0x3fb999999999999a  # 0.1
    %9 = const F64 0x3fc999999999999a  # 0.2
    %10 = const F64 0x3feccccccccccccd  # 0.9
    %11 = const F64 0x8000000000000000  # -0
    %12 = const F64 0xfff0000000000000  # -inf
    %13 = const F64 0x7ff8000000000000  # nan
    %14 = const F64 0x7ff8000000000000  # nan
    %15 = const F64 0x8000000000000000  # -0
    %16 = const F64 0x7ff8000000000000  # nan
    %17 = const F64 0
    %18 = const F64 0
    %19 = const F64 1
    %20 = const F64 0xbfe0000000000000  # -0.5
    %21 = const F64 0x8000000000000000  # -0
    %22 = const F64 1
    %23 = const F64 0x3ff6a09e667f3bcd  # 1.4142135623730951
    %24 = const F64 0x7ff8000000000000  # nan
    %25 = const F64 -1
    %26 = const F64 0x8000000000000000  # -0
    %27 = const F64 0
    %28 = const F64 0x7ff8000000000000  # nan
    %29 = const bool 1
    %30 = const bool 1
    %31 = const bool 0
    %32 = const bool 1
    %33 = const bool 0
    %34 = const bool 0
    %35 = const bool 0
    %36 = const bool 1
    %37 = const bool 1
    ret
}
