spec 7.25  The name before `steps` may also be that of a function, as anywhere that `(` does not follow it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
F64 b
[local]
U8 abs = 2
[define]
min = 3
[Run]
.step
    a = roll_max(p, abs steps)
    b = roll_max(p, min steps)

-- app.ss --
[options]
delta_t 1
[all_states]
true: p = 9 - G
G == 1: @assert a == 9 and b == 9
G == 2: @assert a == 8 and b == 9
G == 3: @assert a == 7 and b == 8
G == 3: @stop
