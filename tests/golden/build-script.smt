# A script is not built.
args build a.ss

-- a.ss --
[options]
delta_t 10
[all_states]
G == 20 {
    @assert open
    @stop
}
-- stderr --
smc: a state script is not built; 'smc test MACHINE.sm a.ss' runs it
Try 'smc build --help'.
-- exit --
2
