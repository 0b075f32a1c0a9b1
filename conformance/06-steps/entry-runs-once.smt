spec 6.7  .entry runs at the first step of a state only.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n
U8 m

[Run]
.entry
    n = n + 1
.step
    m = m + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert n == 1 and m == 1
G == 3: @assert n == 1 and m == 4
G == 3: @stop
