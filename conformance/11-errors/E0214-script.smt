spec 8.10   A script does not write G, S and T.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y @read_only @alias why
[local]
F64 limit = 1 @read_only
F64 count = 1
[Hold]
.step
    x = y + limit + count
    x > 5: -> Abort
[Abort]
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0 {
    G = 1                     #! E0214
    S = 1                     #! E0215
    T = 1                     #! E0216
    why = 1
    y = 2
}
G == 20: @stop
