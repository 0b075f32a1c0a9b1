spec 8.9   @stop is not reported as missing where something could not be read.
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
delta_t 5 bar              #! E0371
[all_states]
G == 5 : : @stop           #! E0341
