spec 8.22, 5.67  The errors of a definition that the script does not use are reported.
warn

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Run]
.step
    x = T
-- app.ss --
[options]
delta_t 1
[define]
none = nothing > 1              #! W0212 none  #! E0204 nothing
[all_states]
G == 1: @assert x == 1
G == 1: @stop
