spec 5.17  A local named like an element of the vector that is not listed is allowed, with a warning.

-- app.sv --
[R]
U64 G
U32 S
F64 p
U8 n

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n

[local]
F64 p = 4   #! W0202

[Run]
.step
    n = p

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert n == 4
    @stop
}
