# Requirements are used with a machine.
args build a.rq
args check a.rq
args test a.rq
args test a.sm a.rq
args graph a.sm a.rq

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool drogue
bool main
[Pad] @req R1
.step
    p > 100: -> Drogue @req R3
[Drogue]
.entry
    drogue = true @req R4
.step
    if T > 50 { -> Main } @req R3
[Main] @safe
.entry
    main = true
-- a.ss --
[all_states]
G == 0: p = 0
G == 100: p = 200
G == 300 {
    @assert main @req R2
    @stop
}
-- a.rq --
# requirements
R1 "no pyro on the pad"      never S == Pad and (drogue or main)
R2 "no main before drogue"   never Main before Drogue
R3 "pressure leads to main"  always p > 100 leads to main within 100 ms
R4 "drogue stays"            always S == Main implies drogue and main
R5 "through drogue"          never Main after Pad without Drogue
-- stderr --
smc: requirements are not built; 'smc test MACHINE.sm SCRIPT.ss a.rq' judges them
Try 'smc build --help'.
smc: requirements are checked with their machine, as in 'smc check tank.sm tank.rq'
Try 'smc check --help'.
smc: requirements are judged in the scripts of a machine, as in 'smc test tank.sm tank.ss tank.rq'
Try 'smc test --help'.
smc: no script is named to test 'a.sm' with, as in 'smc test a.sm SCRIPT.ss'
Try 'smc test --help'.
smc: 'a.rq' is neither a machine (.sm) nor a script (.ss)
Try 'smc graph --help'.
-- exit --
2 2 2 2 2
