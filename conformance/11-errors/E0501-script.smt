spec 8.4, 8.2   A section of a script has the name of a state, and init_state is one.
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
init_state Holt               #! E0501 did you mean 'Hold'?
[Abbort]                      #! E0501 did you mean 'Abort'?
G == 10: @stop
