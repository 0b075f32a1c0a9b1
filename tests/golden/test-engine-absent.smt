# A missing engine: a script cannot be run; cases are run without it, and that is reported.
args --version >/dev/null; CC=nocc "$SMC" test --engine=c a.sm a.ss
args --version >/dev/null; CC=nocc "$SMC" test case.smt

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
-- case.smt --
\-- app.sm --
[state_vector]
U64 G
U32 S
[Idle]
\-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: @assert S == 1
G == 1: @stop
-- stdout --
1 passed, 0 failed, 1 skipped
-- stderr --
smc: engine c: cannot run the C compiler nocc (the variable CC names another): No such file or directory
smc: engine c was left out: cannot run the C compiler nocc (the variable CC names another): No such file or directory
-- exit --
3 0
