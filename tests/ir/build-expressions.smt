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
