# A missing script is reported once, and the others are run.
args test a.sm missing.ss good.ss
args check a.sm missing.ss

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- good.ss --
[options]
delta_t 10
[all_states]
G == 0 {
    @assert S == 1
    @stop
}
-- stdout --
1 passed, 1 failed
-- stderr --
smc: cannot read 'missing.ss': No such file or directory
smc: cannot read 'missing.ss': No such file or directory
-- exit --
3 3
