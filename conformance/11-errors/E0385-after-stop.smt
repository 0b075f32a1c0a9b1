spec 8.8   Nothing follows @stop in its conditional.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p
-- app.ss --
[options]
delta_t 10
[all_states]
G == 100 {
    @stop
    p = 1           #! E0385 '@stop'
    p = 2
}
