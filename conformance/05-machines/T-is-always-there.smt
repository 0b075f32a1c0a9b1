spec 5.6, 2.3  T is read without being listed, and is 0 in the first step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = T + 1

-- app.ss --
[options]
delta_t 10

[all_states]
G == 0: @assert x == 1
G == 30: @assert x == 31 and T == 30
G == 30: @stop
