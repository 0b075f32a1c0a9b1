# --engine=all where no C compiler is installed: the other engines run, and a line says why the C did not.  A compiler that CC or --engine
# names was asked for: it must run, for scripts and for cases.
args --version >/dev/null; CC= PATH=/nowhere "$SMC" test --engine=all a.sm a.ss
args --version >/dev/null; CC= PATH=/nowhere "$SMC" test --engine=all a.sm a.ss --tap
args --version >/dev/null; CC= PATH=/nowhere "$SMC" test --engine=all case.smt
args --version >/dev/null; CC= PATH=/nowhere "$SMC" test --engine=ref,vm,vm-soft,c a.sm a.ss
args --version >/dev/null; CC= PATH=/nowhere "$SMC" test --engine=c case.smt
args --version >/dev/null; mkdir bin; printf '#!/bin/sh\nexit 7\n' >bin/cc; chmod +x bin/cc; CC= PATH=$PWD/bin "$SMC" test --engine=all a.sm a.ss
args --version >/dev/null; CC=bin/cc "$SMC" test --engine=all a.sm a.ss
args --version >/dev/null; CC=bin/cc "$SMC" test --engine=all case.smt
args --version >/dev/null; CC=nocc "$SMC" test --engine=all a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- a.ss --
[options]
delta_t 10
[all_states]
G == 20 {
    @assert S == 1
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
state script ran for 3 steps
1 assert passed
final state vector:
  G = 20
  S = 1
  T = 20
TAP version 13
1..1
ok 1 - a.ss
1 passed, 0 failed, 1 skipped
0 passed, 1 failed
state script ran for 3 steps
1 assert passed
final state vector:
  G = 20
  S = 1
  T = 20
0 passed, 1 failed
-- stderr --
smc: engine c was left out: cannot run the C compiler cc (the variable CC names another): No such file or directory
smc: engine c was left out: cannot run the C compiler cc (the variable CC names another): No such file or directory
smc: engine c was left out: cannot run the C compiler cc (the variable CC names another): No such file or directory
smc: engine c: cannot run the C compiler cc (the variable CC names another): No such file or directory
case.smt: failed
    engine c: cannot run the C compiler cc (the variable CC names another): No such file or directory
smc: engine c was left out: cannot run the C compiler cc (the variable CC names another): 'cc --version' ended with exit code 7
smc: engine c: the C compiler bin/cc does not accept the emitted C: it ended with exit code 7 and no message
case.smt: failed
    engine c: the C compiler bin/cc does not accept the emitted C: it ended with exit code 7 and no message
smc: engine c: cannot run the C compiler nocc (the variable CC names another): No such file or directory
-- exit --
0 0 0 3 3 0 3 3 3
