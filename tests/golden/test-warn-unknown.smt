# The words of a case's `warn` line are those behind -W.
args test case.smt

-- case.smt --
warn extra unused-locals
\-- app.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- exit --
1
-- stdout --
0 passed, 1 failed
-- stderr --
case.smt: failed
    no warning is called 'unused-locals'; did you mean 'unused-local'?
