spec 8.17  The inputs of a conditional are executed in order, although they change the variables of its guard.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 ro @read_only @alias q

[local]
F64 k = 5
F64 c = 7 @read_only

[A]
.step
    x = p
    p == 99: -> B

[B]
.step
    x = p + 1000

-- app.ss --
[options]
delta_t 1

[all_states]
p == 0 {
    p = 1
    k = p + 1
    p = k * 10
}
G == 0: @assert x == 20 and k == 2
G == 0: @stop
