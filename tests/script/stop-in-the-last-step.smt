# The limit is reached, but @stop is in the last step.
steps 5

-- app.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- app.ss --
[options]
delta_t 10
[all_states]
G == 40 {
    @assert S == 1
    @stop
}
