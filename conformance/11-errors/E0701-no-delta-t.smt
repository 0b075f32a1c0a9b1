spec 8.1   delta_t is required.
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
[all_states]                  #! E0701
true: @stop
