# Of one @expect only the oldest is pending: until it is decided, steps in which its guard is true again count nothing. The step that decides it
# begins the next one, which is met at once here.
args test a.sm met.ss
args test a.sm late.ss

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 x @read_only
bool open
[Hold] @safe
.step
    open = x > 5
-- met.ss --
[all_states]
from 0 to 35: @expect open within 50 ms "it opens"
at 30: x = 7
at 60: @stop
-- late.ss --
[all_states]
from 0 to 35: @expect open within 20 ms "it opens"
at 90: @stop
-- stdout --
state script ran for 7 steps
2 asserts passed
final state vector:
  G = 60
  S = 1
  T = 60
  open = true
  x = 7.000000
-- stderr --
late.ss:2:23: error: expected within 20 after G = 0, and not true up to step 3 (G = 20, state Hold): it opens [E0756]
    2 | from 0 to 35: @expect open within 20 ms "it opens"
      |                       ^~~~ open = false
note: the last steps, and the values after each:
      step   G  state   open
         1   0  Hold   false
         2  10  Hold   false
         3  20  Hold   false
note: the machine has been in state 'Hold' from the start
a.sm:10:5: note: step 3 (G = 20): `open = x > 5` stored false: x = 0
1 error
-- exit --
0 1
