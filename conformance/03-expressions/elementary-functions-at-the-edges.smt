spec 3.34, 3.35, 3.36, 3.37, 3.38, 3.39, 3.40, 3.41  Zeros, infinities and NaN, as in Annex F of the C standard.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 one
F64 exps
F64 logs
F64 no_log
F64 pows
F64 pow_ones
F64 no_pow
F64 no_sine
F64 sines
F64 arcs
F64 no_arc
F64 angles
F64 hypots
F64 no_hypot
F64 nans
F64 no_nan

[local]
F64 inf = 1 / 0 @read_only
F64 zero = 0

[Run]
.step
    exps = exp(inf * one) == inf and exp(-inf * one) == 0 and exp(zero) == 1
    logs = log(zero) == -inf and log(-zero) == -inf and log10(zero) == -inf and log(inf * one) == inf and log10(inf * one) == inf
    no_log = log(-one) == log(-one) or log10(-one) == log10(-one) or log(-inf * one) == log(-inf * one)
    pows = pow(zero, -one) == inf and pow(-zero, -one) == -inf and pow(-zero, -2 * one) == inf and 1 / pow(-zero, 3 * one) == -inf
    pow_ones = pow(sqrt(-one), zero) == 1 and pow(one, sqrt(-one)) == 1 and pow(-one, inf) == 1 and pow(inf * one, -zero) == 1
    no_pow = pow(-one, 0.5) == pow(-one, 0.5) or pow(sqrt(-one), one) == pow(sqrt(-one), one)
    no_sine = sin(inf * one) == sin(inf * one) or cos(inf * one) == cos(inf * one) or tan(-inf * one) == tan(-inf * one)
    sines = 1 / sin(-zero) == -inf and 1 / tan(-zero) == -inf and 1 / sin(zero) == inf and cos(-zero) == 1
    arcs = 1 / asin(-zero) == -inf and 1 / atan(-zero) == -inf and atan(inf * one) == 1.5707963267948966 and 1 / acos(one) == inf
    no_arc = asin(1.0000000000000002 * one) == asin(1.0000000000000002 * one) or acos(-2 * one) == acos(-2 * one) or asin(-inf * one) == asin(-inf * one)
    angles = atan2(-zero, -one) == -3.141592653589793 and 1 / atan2(-zero, one) == -inf and atan2(inf * one, -inf) == 2.356194490192345
    hypots = hypot(inf, sqrt(-one)) == inf and hypot(sqrt(-one), -inf * one) == inf and 1 / hypot(-zero, -zero) == inf
    no_hypot = hypot(sqrt(-one), one) == hypot(sqrt(-one), one)
    nans = exp(sqrt(-one)) != 0 and log(sqrt(-one)) != 0 and sin(sqrt(-one)) != 0 and atan2(sqrt(-one), one) != 0 and atan2(one, sqrt(-one)) != 0
    no_nan = exp(sqrt(-one)) == exp(sqrt(-one)) or atan(sqrt(-one)) == atan(sqrt(-one)) or acos(sqrt(-one)) == acos(sqrt(-one))

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: one = 1
G == 1 {
    @assert exps
    @assert logs
    @assert not no_log
    @assert pows
    @assert pow_ones
    @assert not no_pow
    @assert not no_sine
    @assert sines
    @assert arcs
    @assert not no_arc
    @assert angles
    @assert hypots
    @assert not no_hypot
    @assert nans
    @assert not no_nan
    @stop
}
