spec 7.18, 7.8  A statistic that is 0 or -0 is the same in comparisons, and keeps its sign where it is stored or divides.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F32 q
bool never
bool equal
bool reached
F64 median3
F32 least
F64 most
F64 inverse
I16 whole

[Compare]
.step
    never = roll_median(p, 3) < 0 or roll_min(q, 4) < 0 or roll_max(p, 5) < 0
    equal = roll_median(p, 3) == 0 and roll_min(q, 4) == 0 and roll_max(p, 5) == 0
    reached = roll_median(q, 3) >= 0 and roll_max(q, 6) >= 0 and roll_min(p, 6) <= 0
    whole = roll_min(p, 7)
    G == 5: -> Store

[Store]
.step
    never = roll_median(p, 3) < 0
    median3 = roll_median(p, 3)
    least = roll_min(q, 4)
    most = roll_max(p, 5)
    inverse = 1 / roll_min(q, 5)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = -0.0
true: q = -0.0
G == 0: p = 0
G == 8: p = 0
G == 9: p = 0
G == 9: q = 0
G == 6: @assert never == false and equal == true and reached == true
G == 6: @assert 1 / median3 < 0 and 1 / least < 0 and 1 / most < 0
G == 6: @assert inverse < -1e300
G == 7: @assert 1 / median3 < 0
G == 10: @assert 1 / median3 > 0 and 1 / most > 0 and 1 / least < 0 and whole == 0
G == 12: @stop
