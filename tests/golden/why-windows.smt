# Windows: statistics that are not full, edges, previous values, and what would have made a difference in the step.
args why a.sm a.ss --at-step=2
args why a.sm a.ss --to=Edge
args why a.sm a.ss --to=Slow
args why a.sm a.ss --of=n

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool button @read_only
U32 n

[Wait]
.step
    n = round(roll_max(p, 3))
    rising(button) and p > 5: -> Edge
    p > prev(p) + 10: -> Fast
    roll_avg(p, 5 steps) < 2 and held(p < 3, 4 steps): -> Slow

[Edge] @safe
[Fast] @safe
[Slow] @safe
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 4
G == 20: button = true
G == 30: p = 2.5
G == 50: button = false
G == 60: p = 9
G == 80: p = 1
G == 100: @stop
-- stdout --
step 2 (G = 10): Wait, entered in step 1 (G = 0); took no transition
  a.sm:12: `n = round(roll_max(p, 3))` stored 4: roll_max(p, 3) = 4 from 2 of 3 samples
  a.sm:13: `rising(button) and p > 5` was false since step 1 (G = 0)
    `rising(button)` was false since step 1 (G = 0)
    `p > 5` was false since step 1 (G = 0): p = 4, needs more than 1 more
  a.sm:14: `p > prev(p) + 10` was false since step 1 (G = 0): p = 4, prev(p) + 10 = 14, prev(p) = 4, needs more than 10 more
  a.sm:15: `roll_avg(p, 5 steps) < 2 and held(p < 3, 4 steps)` was false since step 1 (G = 0)
    `roll_avg(p, 5 steps) < 2` was false since step 1 (G = 0): roll_avg(p, 5 steps) = 4 from 2 of 5 samples, needs more than 2 less
    `held(p < 3, 4 steps)` was false since step 1 (G = 0); its condition was false when the step began
what would have made a difference in this step:
  with p just above 14 (it was 4), the step would have taken the transition to Fast
where the values come from:
  a.sm:7: nothing has written button, so it has its first value
  a.ss:4: the script wrote p in step 1, by `p = 4`
step 11 (G = 100): Wait, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:13: `rising(button) and p > 5` was false since step 1 (G = 0)
    `rising(button)` was false since step 4 (G = 30)
    `p > 5` was false since step 9 (G = 80): p = 1, needs more than 4 more
a.sm:13: Wait -> Edge was never taken; step 3 (G = 20) was nearest to taking it:
  a.sm:13: `rising(button) and p > 5` was false since step 1 (G = 0)
    `rising(button)` was true, since this step
    `p > 5` was false since step 1 (G = 0): p = 4, needs more than 1 more
  what would have made a difference in this step:
    with p just above 5 (it was 4), the step would have taken the transition to Edge
where the values come from:
  a.ss:7: the script wrote button in step 6, by `button = false`
  a.ss:9: the script wrote p in step 9, by `p = 1`
step 11 (G = 100): Wait, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:15: `roll_avg(p, 5 steps) < 2 and held(p < 3, 4 steps)` was false since step 1 (G = 0)
    `roll_avg(p, 5 steps) < 2` was false since step 1 (G = 0): roll_avg(p, 5 steps) = 4.2, needs more than 2.2 less
    `held(p < 3, 4 steps)` was false since step 1 (G = 0); its condition was true for 3 of 4 steps
a.sm:15: Wait -> Slow was never taken; step 6 (G = 50) was nearest to taking it:
  a.sm:15: `roll_avg(p, 5 steps) < 2 and held(p < 3, 4 steps)` was false since step 1 (G = 0)
    `roll_avg(p, 5 steps) < 2` was false since step 1 (G = 0): roll_avg(p, 5 steps) = 3.1, needs more than 1.1 less
    `held(p < 3, 4 steps)` was false since step 1 (G = 0); its condition was true for 3 of 4 steps
where the values come from:
  a.ss:9: the script wrote p in step 9, by `p = 1`
step 11 (G = 100): n = 1, last stored in this step
step 11 (G = 100): Wait, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:12: `n = round(roll_max(p, 3))` stored 1: roll_max(p, 3) = 1
where the values come from:
  a.ss:9: the script wrote p in step 9, by `p = 1`
