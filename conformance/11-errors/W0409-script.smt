spec 2.14   So does one that a script stores: the machine reads 0.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x > 5: x = 0
-- app.ss --
[options]
delta_t 10
[all_states]
G == 10: x = 0 / 0            #! W0409 'x' stores 0
G == 20: @assert x == 0
G == 30: @stop
