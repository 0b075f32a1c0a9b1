# A script without a machine.
args test a.ss

-- a.ss --
[options]
delta_t 10
[all_states]
G == 20 {
    @assert open
    @stop
}
-- stderr --
smc: no machine is named to run the script on, as in 'smc test MACHINE.sm SCRIPT.ss'
Try 'smc test --help'.
-- exit --
2
