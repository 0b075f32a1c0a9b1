spec 8.12  Elements are zero when a script starts, and locals have their initial values.

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
true: @assert p == 0 and 1 / p == 1/0 and ro == 0 and k == 5 and c == 7
true: @stop
