spec 8.4   In a script a state has one section.
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
[Hold]
G == 0: x = 1
[Hold]                        #! E0704 the first one is here
G == 10: @stop
