spec 8.4   A script declares nothing.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p
-- app.ss --
[options]
delta_t 10
[local]        #! E0304 [local]
F64 a = 1
[all_states]
G == 100: @stop
