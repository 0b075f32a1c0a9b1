# Every operator and builtin, bools where bools are wanted and numbers where numbers are, constants of locals, conversions before stores.

-- e.sm --
[state_vector]
U64 G
U32 S
U8 u
F32 f
F64 x
bool p
bool q @read_only
[local]
U16 w = 800
U16 limit = 70000 @read_only
bool yes = 3 @read_only
[A]
.entry
    u = p
    p = u
    p = q
    p = q and not (u > limit) or yes
    x = (x < 1) + q
    x = x
    f = x
    w = G + T + S
    p = -u < +w <= x > 3 >= x
    p = x == 1
    q + 1: x = q != yes
    -x: x = x
    !q { x = 1 }
.step
    x = (x + 1) * (x - 2) / x
    x = abs(x) + floor(x) + ceil(x) + trunc(x) + round(x) + sqrt(x) + sign(x)
    x = min(x, w) + max(1, x) + clamp(x, u, w)
-- ir out --
machine "e"
vector "e" size 40 hash 0xdf9ca937

element U64 G at 0 is G
element U32 S at 8 is S
element U8 u writable at 12
element F32 f writable at 16
element F64 x writable at 24
element bool p writable at 32
element bool q at 33
local U16 w writable = 800
time U64 T

state A
entry {
b0:
    %0 = load bool p
    %1 = cvt F64 %0
    %2 = cvt U8 %1
    store U8 u, %2
    %3 = load U8 u
    %4 = cvt F64 %3
    %5 = cvt bool %4
    store bool p, %5
    %6 = load bool q
    store bool p, %6
    %7 = load bool q
    %8 = load U8 u
    %9 = cvt F64 %8
    %10 = const F64 65535
    %11 = gt F64 %9, %10
    %12 = not %11
    %13 = and %7, %12
    %14 = const bool 1
    %15 = or %13, %14
    store bool p, %15
    %16 = load F64 x
    %17 = const F64 1
    %18 = lt F64 %16, %17
    %19 = cvt F64 %18
    %20 = load bool q
    %21 = cvt F64 %20
    %22 = add F64 %19, %21
    %23 = cvt F64 %22
    store F64 x, %23
    %24 = load F64 x
    %25 = cvt F64 %24
    store F64 x, %25
    %26 = load F64 x
    %27 = cvt F32 %26
    store F32 f, %27
    %28 = load U64 G
    %29 = cvt F64 %28
    %30 = load U64 T
    %31 = cvt F64 %30
    %32 = add F64 %29, %31
    %33 = load U32 S
    %34 = cvt F64 %33
    %35 = add F64 %32, %34
    %36 = cvt U16 %35
    store U16 w, %36
    %37 = load U8 u
    %38 = cvt F64 %37
    %39 = neg F64 %38
    %40 = load U16 w
    %41 = cvt F64 %40
    %42 = lt F64 %39, %41
    %43 = load F64 x
    %44 = le F64 %41, %43
    %45 = and %42, %44
    %46 = const F64 3
    %47 = gt F64 %43, %46
    %48 = and %45, %47
    %49 = load F64 x
    %50 = ge F64 %46, %49
    %51 = and %48, %50
    store bool p, %51
    %52 = load F64 x
    %53 = const F64 1
    %54 = eq F64 %52, %53
    store bool p, %54
    %55 = load bool q
    %56 = cvt F64 %55
    %57 = const F64 1
    %58 = add F64 %56, %57
    %59 = cvt bool %58
    br %59, b1, b2
b1:
    %60 = load bool q
    %61 = cvt F64 %60
    %62 = const bool 1
    %63 = cvt F64 %62
    %64 = ne F64 %61, %63
    %65 = cvt F64 %64
    %66 = cvt F64 %65
    store F64 x, %66
    jmp b2
b2:
    %67 = load F64 x
    %68 = neg F64 %67
    %69 = cvt bool %68
    br %69, b3, b4
b3:
    %70 = load F64 x
    %71 = cvt F64 %70
    store F64 x, %71
    jmp b4
b4:
    %72 = load bool q
    %73 = not %72
    br %73, b5, b6
b5:
    %74 = const F64 1
    %75 = cvt F64 %74
    store F64 x, %75
    jmp b6
b6:
    ret
}
step {
b0:
    %0 = load F64 x
    %1 = const F64 1
    %2 = add F64 %0, %1
    %3 = load F64 x
    %4 = const F64 2
    %5 = sub F64 %3, %4
    %6 = mul F64 %2, %5
    %7 = load F64 x
    %8 = div F64 %6, %7
    %9 = cvt F64 %8
    store F64 x, %9
    %10 = load F64 x
    %11 = abs F64 %10
    %12 = load F64 x
    %13 = floor F64 %12
    %14 = add F64 %11, %13
    %15 = load F64 x
    %16 = ceil F64 %15
    %17 = add F64 %14, %16
    %18 = load F64 x
    %19 = trunc F64 %18
    %20 = add F64 %17, %19
    %21 = load F64 x
    %22 = round F64 %21
    %23 = add F64 %20, %22
    %24 = load F64 x
    %25 = sqrt F64 %24
    %26 = add F64 %23, %25
    %27 = load F64 x
    %28 = sign F64 %27
    %29 = add F64 %26, %28
    %30 = cvt F64 %29
    store F64 x, %30
    %31 = load F64 x
    %32 = load U16 w
    %33 = cvt F64 %32
    %34 = min F64 %31, %33
    %35 = const F64 1
    %36 = load F64 x
    %37 = max F64 %35, %36
    %38 = add F64 %34, %37
    %39 = load F64 x
    %40 = load U8 u
    %41 = cvt F64 %40
    %42 = load U16 w
    %43 = cvt F64 %42
    %44 = max F64 %39, %41
    %45 = min F64 %44, %43
    %46 = add F64 %38, %45
    %47 = cvt F64 %46
    store F64 x, %47
    ret
}
