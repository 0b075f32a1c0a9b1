spec 8.11   A script uses the elements, aliases and locals of the machine; an unknown name is reported once.
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
G == 0: z = 1                 #! E0204 unknown element 'z'
z > 1: x = why + limi         #! E0204 did you mean 'limit'?
G == 10: @assert z == limi
G == 20: @stop
