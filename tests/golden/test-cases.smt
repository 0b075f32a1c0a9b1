# Cases: what each announces is held against what comes.
args test cases

-- cases/good.smt --
\-- app.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- cases/bad.smt --
\-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @alias x
[Idle]
.step
    y = 1
    x = z       #! E0204 unknown element 'z'
    x = 2       #! W0501 nothing
-- cases/inner/report.smt --
on ref
\-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Idle]
.step
    x = x + 1
\-- app.ss --
[options]
delta_t 1
[all_states]
G == 1: @stop
\-- report --
state script ran for 2 steps
0 asserts passed
final state vector:
  G = 2
  S = 1
  T = 1
  x = 2.000000
\-- trace --
1 x 0x1p+0
2 x 0x1p+2
-- cases/.hidden.smt --
-- cases/note.txt --
-- cases/malformed.smt --
expect perhaps
-- stdout --
1 passed, 3 failed
-- stderr --
cases/bad.smt: failed
    not announced: app.sm:4:7: warning: the alias of 'x' repeats its own name [W0201 alias-own-name]
    not announced: app.sm:7:5: error: unknown element 'y' [E0204]
    announced, but not reported: app.sm:9: W0501 nothing
cases/inner/report.smt: failed
    the report differs (- expected, + came):
      -   G = 2
      +   G = 1
    the trace has no line '2 x 0x1p+2' here; it has '2 x 0x1p+1'
cases/malformed.smt: failed
    line 1: expect takes pass, fail or error
-- exit --
1
