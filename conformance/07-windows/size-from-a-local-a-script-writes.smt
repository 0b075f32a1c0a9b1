spec 7.3, 5.14  A script that writes the local does not change the window.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[local]
U8 n = 2 @read_only

[Run]
.step
    x = roll_max(p, n)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    p = 9
    n = 4   #! W0701
}
G == 1: p = 1
G == 2: @assert x == 1 and n == 4
G == 2: @stop
