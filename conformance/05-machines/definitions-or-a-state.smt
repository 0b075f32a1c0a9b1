spec 5.64  [define] without a definition is a state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Run]
.step
    -> define
[define] @safe
.step
    S == define: x = 5
-- app.ss --
[options]
delta_t 1
[define]
T == 1: @assert x == 5 and S == define   #! W0752
T == 1: @stop
