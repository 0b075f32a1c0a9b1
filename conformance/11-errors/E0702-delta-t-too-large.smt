spec 8.1   delta_t is a whole number from 1 to 9223372036854775808.
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
delta_t 9223372036854777856   #! E0702
[all_states]
true: @stop
