spec 8.8   After @stop nothing may follow in its conditional.
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
G == 10 {
    @stop
    @assert x == 1            #! E0704 @stop is here
    x = 2
}
G == 20 {
    @stop
    @stop                     #! E0704
}
