# A held with a time needs one sample more than a window of as many steps: W1300 names it where the condition before 'implies' contains one.
args test m.sm m.ss m.rq

-- m.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 t @read_only
bool valve
[Burn] @safe
.entry
    valve = true
.step
    roll_min(t, 10) > 180: valve = false
-- m.ss --
[all_states]
if G >= 100 and G < 200: t = 200
else: t = 20
at 500: @stop
-- m.rq --
R1 "time"    always held(t > 180, 100 ms) implies not valve
R2 "steps"   always held(t > 180, 10 steps) implies not valve
R3 "never"   always t < 0 implies valve
-- stdout --
state script ran for 51 steps
0 asserts passed
final state vector:
  G = 500
  S = 1
  T = 500
  t = 20.000000
  valve = false
requirements:
  R1  never judged  time
  R2  met           steps
      judged in m.ss: 1
  R3  never judged  never
-- stderr --
m.rq:1:1: warning: requirement R1 was never judged: time [W1300 unjudged-requirement]
    1 | R1 "time"    always held(t > 180, 100 ms) implies not valve
      | ^~
m.rq:1:21: note: a time in 'held' takes one sample more than as many steps: at a step of 10 ms, 'held(c, 100 ms)' needs 11 samples, 'held(c, 10 steps)' 10
m.rq:3:1: warning: requirement R3 was never judged: never [W1300 unjudged-requirement]
    3 | R3 "never"   always t < 0 implies valve
      | ^~
2 warnings
