spec 8.7   A conditional without items is an error in a script.
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
G == 0 { }                    #! E0705
G == 10: @stop
