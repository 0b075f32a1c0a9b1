spec 5.75, 7.4  A window of [all_states] is one window, which samples in every state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[all_states] @except Wait
.step
    x = roll_avg(p, 3)
[Run]
.step
    T > 0: -> Wait
[Wait]
.step
    T > 0: -> Next
[Next]

-- app.ss --
[options]
delta_t 1
[all_states]
true: p = G
G == 1: @assert x == 0.5
G == 3: @assert x == 0.5
G == 4: @assert x == 3
G == 4: @assert S == Next
G == 4: @stop
