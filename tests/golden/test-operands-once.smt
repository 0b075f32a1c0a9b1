# The values that explain a guard and an assert: no constant as its own value, and each operand once.
args test a.sm a.ss
args why a.sm a.ss --at=50

-- a.sm --
[state_vector]
U64 G
U32 S
F64 h1 @read_only
F64 h2 @read_only
bool open
bool ok
[define]
ok1 = h1 > -100 and h1 < 9000
ok2 = h2 > -100 and h2 < 9000
[Wait] @safe
.step
    ok = ok1 and h1 > -50 or ok2
    ok1 and (h1 > -20 or ok2) and h1 > 500: -> Open
[Open] @safe
.step
    open = true
-- a.ss --
[options]
delta_t 10
[all_states]
true: h1 = -101
true: h2 = 9001
at 50: @assert ok or h1 > -100 and h1 > -200 or state Open
at 60: @stop
-- stdout --
step 6 (G = 50): Wait, entered in step 1 (G = 0); took no transition
the script failed after this step, at a.ss:6
  a.sm:13: `ok = ok1 and h1 > -50 or ok2` stored false: h1 = -101, h2 = 9001
  a.sm:14: `ok1 and (h1 > -20 or ok2) and h1 > 500` was false since step 1 (G = 0)
    `h1 > -100` was false since step 1 (G = 0): h1 = -101, needs more than 1 more
    `h1 < 9000` was true since step 1 (G = 0): h1 = -101
    `h1 > -20 or ok2` was false since step 1 (G = 0)
      `h1 > -20` was false since step 1 (G = 0): h1 = -101, needs more than 81 more
      `ok2` was false since step 1 (G = 0)
        `h2 > -100` was true since step 1 (G = 0): h2 = 9001
        `h2 < 9000` was false since step 1 (G = 0): h2 = 9001, needs more than 1 less
    `h1 > 500` was false since step 1 (G = 0): h1 = -101, needs more than 601 more
what would have made a difference in this step:
  with h1 just below 9000 (it was -101), the step would have taken the transition to Open
where the values come from:
  a.ss:4: the script wrote h1 in step 6, by `h1 = -101`
  a.ss:5: the script wrote h2 in step 6, by `h2 = 9001`
-- stderr --
a.ss:6:16: error: assert failed after step 6 (G = 50, state Wait) [E0750]
    6 | at 50: @assert ok or h1 > -100 and h1 > -200 or state Open
      |                ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ ok = false, h1 = -101
note: the last steps, and the values after each:
      step   G  state     ok    h1
         2  10  Wait   false  -101
         3  20  Wait   false  -101
         4  30  Wait   false  -101
         5  40  Wait   false  -101
         6  50  Wait   false  -101
note: the machine has been in state 'Wait' from the start
a.sm:13:5: note: step 6 (G = 50): `ok = ok1 and h1 > -50 or ok2` stored false: h1 = -101, h2 = 9001
a.sm:14:45: note: Wait -> Open was not taken: `h1 > -100` was false: h1 = -101, needs more than 1 more
1 error
-- exit --
1 0
