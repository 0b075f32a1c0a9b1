# An option that takes no value is given one.
args test --tap=yes a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 20 {
    @assert open
    @stop
}
-- stderr --
smc: option '--tap' has no value
Try 'smc test --help'.
-- exit --
2
