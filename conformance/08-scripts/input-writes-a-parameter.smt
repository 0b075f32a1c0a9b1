spec 8.38  A script cannot assign a parameter.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
F64 a = 1 @parameter @range 0 9
[Run]
.step
    x = a
-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: a = 2         #! E0423 a script cannot assign 'a': it is a parameter
G == 0: @stop
