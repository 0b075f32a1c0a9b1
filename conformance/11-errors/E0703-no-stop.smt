spec 8.9   A script has at least one @stop.
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
[options]                     #! E0703
delta_t 10
[all_states]
G == 0: x = 1
