spec 6.18, 6.8  A transition of .entry comes before those of .step, wherever the blocks stand.

-- app.sm --
[state_vector]
U64 G
U32 S

[A]
.step
    -> C
.entry
    -> B
[B]
[C]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 1: @assert S == 2
G == 1: @stop
