# --trace is for one script.
args test --trace=t.txt a.sm a.ss bad.ss

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
-- bad.ss --
[options]
delta_t 10
[all_states]
G == 20: @assert not open
G == 30: @stop
-- stderr --
smc: --trace wants one machine and one script
Try 'smc test --help'.
-- exit --
2
