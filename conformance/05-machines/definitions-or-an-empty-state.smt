spec 5.64  An empty [define] is a state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Run]
.step
    x = 1
    -> define
[define]
-- app.ss --
[options]
delta_t 1
[all_states]
G == 1: @assert S == 2
G == 1: @stop
