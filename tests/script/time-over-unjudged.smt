# A run that ended badly says nothing about asserts that it never came to: it could have judged them later.
expect fail

-- app.sm --
[state_vector]
U64 G
U32 S
U8  n

[Run]
.step
    n = n + 1

-- app.ss --
[options]
delta_t 9223372036854775808     #! E0752

[all_states]
n > 100: @assert n > 100
n > 200: @stop
