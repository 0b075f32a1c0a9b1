# Recorded data: where a value comes from, the nearest step, a change of a recorded value, and times without a step.
args why a.sm a.ss --to=Vent
args why a.sm a.ss p --at=1720
args why a.sm a.ss --at=100
args why a.sm a.ss --at=1730
args why a.sm a.ss --at=9000

-- a.sm --
[options]
step 20 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open

[Fill]
.step
    p > 31 and roll_avg(p, 2) > 20: -> Vent

[Vent] @safe
.step
    open = true
-- a.csv --
time;PT;CMD
1.7;20;0
1.72;29;0
1.74;30.5;0
1.76;12;0
-- a.ss --
[options]
delta_t 20
[data]
file "a.csv"
time "time" s
p = "PT" @scale 1
@compare open "CMD"
[all_states]
G == 1760: @stop
-- stdout --
step 89 (G = 1760): Fill, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:11: `p > 31 and roll_avg(p, 2) > 20` was false since step 1 (G = 0)
    `p > 31` was false since step 1 (G = 0): p = 12, needs more than 19 more
    `roll_avg(p, 2) > 20` was false since step 5 (G = 80): roll_avg(p, 2) = 12, needs more than 8 more
what would have made a difference in this step:
  with p just above 31 (it was 12), the step would have taken the transition to Vent
a.sm:11: Fill -> Vent was never taken; step 3 (G = 40) was nearest to taking it:
  a.sm:11: `p > 31 and roll_avg(p, 2) > 20` was false since step 1 (G = 0)
    `p > 31` was false since step 1 (G = 0): p = 30.5, needs more than 0.5 more
    `roll_avg(p, 2) > 20` was true since step 2 (G = 20): roll_avg(p, 2) = 29.75
  what would have made a difference in this step:
    with p just above 31 (it was 30.5), the step would have taken the transition to Vent
where the values come from:
  a.ss:6: p is column 'PT' of 'a.csv'
step 87 (G = 1720): p = 12
  a.ss:6: p is column 'PT' of 'a.csv'
step 6 (G = 100): Fill, entered in step 1 (G = 0); took no transition
  a.sm:11: `p > 31 and roll_avg(p, 2) > 20` was false since step 1 (G = 0)
    `p > 31` was false since step 1 (G = 0): p = 12, needs more than 19 more
    `roll_avg(p, 2) > 20` was false since step 5 (G = 80): roll_avg(p, 2) = 12, needs more than 8 more
what would have made a difference in this step:
  with p just above 31 (it was 12), the step would have taken the transition to Vent
where the values come from:
  a.ss:6: p is column 'PT' of 'a.csv'
-- stderr --
smc: no step has G = 1730: its neighbours are G = 1720 and G = 1740
smc: no step has G = 9000: the script ended in step 89 (G = 1760)
-- exit --
0 0 0 1 1
