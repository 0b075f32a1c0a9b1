spec 5.3, 5.4  Elements of other names may take the roles of G and S, and are read under both names.

-- app.sm --
[state_vector]
U64 time @alias G
U32 mode @alias S
F64 x

[A]
.step
    x = time + G * 10 + mode * 1000 + S * 10000
    G == 4: -> B

[B]
.step
    x = mode

-- app.ss --
[options]
delta_t 2

[all_states]
G == 4: @assert x == 44 + 11000 and time == 4 and mode == 1
G == 6: @assert x == 2
G == 6: @stop
