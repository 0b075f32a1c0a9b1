spec 3.18  Elements, locals and states can have the names of the elementary functions.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 exp
F64 log
F64 atan2
F64 result
[local]
F64 sin = 2
F64 pow = 3
[hypot]
.step
    log = log(exp) + exp
    result = pow(sin, pow) + exp - sin
    G == 1: -> tan
[tan]
.step
    atan2 = atan2(0, -1)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: exp = 1
G == 2 {
    @assert log == 1
    @assert result == 7
    @assert S == 2
    @assert atan2 == 3.141592653589793
    @stop
}
