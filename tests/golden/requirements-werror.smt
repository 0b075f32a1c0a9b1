# A requirement that no script has judged is an error with -Werror.
args test -Werror a.sm a.ss a.rq

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool drogue
bool main
[Pad]
.step
    p > 100: -> Drogue
[Drogue]
.entry
    drogue = true
.step
    if T > 50 { -> Main }
[Main] @safe
.entry
    main = true
-- a.ss --
[all_states]
G == 0: p = 0
G == 100: p = 200
G == 300 {
    @assert main
    @stop
}
-- a.rq --
R1 "never"  always p < 0 implies main
-- stdout --
state script ran for 31 steps
1 assert passed
final state vector:
  G = 300
  S = 3
  T = 120
  drogue = true
  main = true
  p = 200.000000
requirements:
  R1  never judged  never
-- stderr --
a.rq:1:1: error: requirement R1 was never judged: never [W1300 unjudged-requirement]
    1 | R1 "never"  always p < 0 implies main
      | ^~
1 error
-- exit --
1
