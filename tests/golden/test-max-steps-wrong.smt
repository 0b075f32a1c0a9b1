# --max-steps wants a number.
args test --max-steps=0 a.sm a.ss
args test --max-steps=1e6 a.sm a.ss

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
smc: --max-steps requires a whole number from 1, not '0'
Try 'smc test --help'.
smc: --max-steps requires a whole number from 1, not '1e6'
Try 'smc test --help'.
-- exit --
2 2
