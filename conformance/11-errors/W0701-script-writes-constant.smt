spec 5.14, 8.10   A script can write a @read_only local; the test reports it once.
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
    limit = 5                 #! W0701 'limit' is declared here
    limit = 6
    count = 5
    y = 5
}
G == 10: limit = 7
G == 20 {
    @assert x > 5
    @stop
}
