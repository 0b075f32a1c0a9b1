spec 6.7, 2.3  .entry runs once although T, read as a number, does not tell 0 from the next step: a condition on T does not decide.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n
F64 x

[Run]
.entry
    n = n + 1
.step
    x = T

-- app.ss --
[options]
delta_t 1

[all_states]
true: @assert n == 1
G == 5: @stop
