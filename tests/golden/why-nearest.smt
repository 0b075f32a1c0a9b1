# The step that was nearest to a transition that the run never took; a machine that was never in its state; windows and nested guards.
args why a.sm a.ss --to=Abort
args why a.sm a.ss --to=Abort --format=json
args why a.sm a.ss --to=Idle
args why a.sm flat.ss --to=Abort
args why a.sm taken.ss --to=Abort
args why a.sm a.ss --to=Abort --at-step=6
args why b.sm b.ss --to=Two
args why b.sm b.ss --to=Three
args why b.sm b.ss --to=Four

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool armed @read_only

[Fill]
.step
    armed and p > 825: -> Abort

[Abort] @abort @safe
.step
    held(p < 100, 50 ms): -> Idle
    p > 900: -> Fill

[Idle] @safe
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 850
G == 20: armed = true
G == 20: p = 800
G == 40: p = 820
G == 60: p = 600
G == 70: @stop
-- flat.ss --
[options]
delta_t 10
[all_states]
G == 0: armed = true
G == 0: p = 700
G == 70: @stop
-- taken.ss --
[options]
delta_t 10
[all_states]
G == 0: armed = true
G == 0: p = 850
G == 20: p = 950
G == 30: p = 0
G == 70: @stop
-- b.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
I32 n @read_only

[One]
.step
    n > 0 {
        10 < p < 20 or n > 7: -> Two
    }
    held(p > 5, 40 ms): -> Three
    roll_avg(p, 4) > 9: -> Four

[Two]
[Three]
[Four]
-- b.ss --
[options]
delta_t 10
[all_states]
G == 0: n = 0
G == 0: p = 9
G == 30: p = 4
G == 60: n = 3
G == 70: p = 24
G == 80: n = 5
G == 80: p = 1
G == 100: @stop
-- stdout --
step 8 (G = 70): Fill, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:11: `armed and p > 825` was false since step 1 (G = 0)
    `armed` was true since step 3 (G = 20)
    `p > 825` was false since step 3 (G = 20): p = 600, needs more than 225 more
what would have made a difference in this step:
  with p just above 825 (it was 600), the step would have taken the transition to Abort
a.sm:11: Fill -> Abort was never taken; step 5 (G = 40) was nearest to taking it:
  a.sm:11: `armed and p > 825` was false since step 1 (G = 0)
    `armed` was true since step 3 (G = 20)
    `p > 825` was false since step 3 (G = 20): p = 820, needs more than 5 more
  what would have made a difference in this step:
    with p just above 825 (it was 820), the step would have taken the transition to Abort
where the values come from:
  a.ss:5: the script wrote armed in step 3, by `armed = true`
  a.ss:8: the script wrote p in step 7, by `p = 600`
{"smc-why":1,"step":8,"G":70,"lines":[
{"kind":"step","depth":0,"text":"step 8 (G = 70): Fill, entered in step 1 (G = 0); took no transition","step":8},
{"kind":"remark","depth":0,"text":"the script stopped after this step"},
{"kind":"guard","depth":1,"text":"`armed and p > 825` was false since step 1 (G = 0)","file":"a.sm","line":11,"column":5,"value":false,"since":1},
{"kind":"condition","depth":2,"text":"`armed` was true since step 3 (G = 20)","value":true,"since":3},
{"kind":"condition","depth":2,"text":"`p > 825` was false since step 3 (G = 20): p = 600, needs more than 225 more","value":false,"gap":225,"since":3},
{"kind":"heading","depth":0,"text":"what would have made a difference in this step:"},
{"kind":"change","depth":1,"text":"with p just above 825 (it was 600), the step would have taken the transition to Abort","variable":"p","value":"825.0000000000001","was":"600","whole_run":false,"transition":"Abort"},
{"kind":"nearest","depth":0,"text":"Fill -> Abort was never taken; step 5 (G = 40) was nearest to taking it:","file":"a.sm","line":11,"column":24,"step":5},
{"kind":"guard","depth":1,"text":"`armed and p > 825` was false since step 1 (G = 0)","file":"a.sm","line":11,"column":5,"value":false,"since":1},
{"kind":"condition","depth":2,"text":"`armed` was true since step 3 (G = 20)","value":true,"since":3},
{"kind":"condition","depth":2,"text":"`p > 825` was false since step 3 (G = 20): p = 820, needs more than 5 more","value":false,"gap":5,"since":3},
{"kind":"heading","depth":1,"text":"what would have made a difference in this step:"},
{"kind":"change","depth":2,"text":"with p just above 825 (it was 820), the step would have taken the transition to Abort","variable":"p","value":"825.0000000000001","was":"820","whole_run":false,"transition":"Abort"},
{"kind":"heading","depth":0,"text":"where the values come from:"},
{"kind":"origin","depth":1,"text":"the script wrote armed in step 3, by `armed = true`","file":"a.ss","line":5,"column":10,"step":3},
{"kind":"origin","depth":1,"text":"the script wrote p in step 7, by `p = 600`","file":"a.ss","line":8,"column":10,"step":7}
]}
step 8 (G = 70): Fill, entered in step 1 (G = 0); took no transition
the script stopped after this step
  Fill has no transition to Idle
  a.sm:15: Abort leads to Idle; the machine was never in it
the shortest path is Fill -> Abort -> Idle; its first transition:
  a.sm:11: `armed and p > 825` was false since step 1 (G = 0)
    `armed` was true since step 3 (G = 20)
    `p > 825` was false since step 3 (G = 20): p = 600, needs more than 225 more
what would have made a difference in this step:
  with p just above 825 (it was 600), the step would have taken the transition to Abort
the machine was never in a state from which a transition leads to Idle
a.sm:11: Fill -> Abort was never taken; step 5 (G = 40) was nearest to taking it:
  a.sm:11: `armed and p > 825` was false since step 1 (G = 0)
    `armed` was true since step 3 (G = 20)
    `p > 825` was false since step 3 (G = 20): p = 820, needs more than 5 more
  what would have made a difference in this step:
    with p just above 825 (it was 820), the step would have taken the transition to Abort
where the values come from:
  a.ss:5: the script wrote armed in step 3, by `armed = true`
  a.ss:8: the script wrote p in step 7, by `p = 600`
step 8 (G = 70): Fill, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:11: `armed and p > 825` was false since step 1 (G = 0)
    `armed` was true since step 1 (G = 0)
    `p > 825` was false since step 1 (G = 0): p = 700, needs more than 125 more
what would have made a difference in this step:
  with p just above 825 (it was 700), the step would have taken the transition to Abort
a.sm:11: Fill -> Abort was never taken, and no step was nearer to taking it than this one
where the values come from:
  flat.ss:4: the script wrote armed in step 1, by `armed = true`
  flat.ss:5: the script wrote p in step 1, by `p = 700`
step 8 (G = 70): Fill, entered in step 4 (G = 30); took no transition
the script stopped after this step
  a.sm:11: `armed and p > 825` was false since step 4 (G = 30)
    `armed` was true since step 4 (G = 30)
    `p > 825` was false since step 4 (G = 30): p = 0, needs more than 825 more
what would have made a difference in this step:
  with p just above 825 (it was 0), the step would have taken the transition to Abort
a.sm:11: Fill -> Abort was last taken in step 1 (G = 0)
where the values come from:
  taken.ss:4: the script wrote armed in step 1, by `armed = true`
  taken.ss:7: the script wrote p in step 4, by `p = 0`
how the machine got there:
  a.sm:16: step 3 (G = 20): Abort -> Fill, because `p > 900` was true: p = 950
  a.sm:11: step 1 (G = 0): Fill -> Abort, because `armed and p > 825` was true: armed = true, p = 850
  the run began in Fill
step 6 (G = 50): Fill, entered in step 1 (G = 0); took no transition
  a.sm:11: `armed and p > 825` was false since step 1 (G = 0)
    `armed` was true since step 3 (G = 20)
    `p > 825` was false since step 3 (G = 20): p = 820, needs more than 5 more
what would have made a difference in this step:
  with p just above 825 (it was 820), the step would have taken the transition to Abort
where the values come from:
  a.ss:5: the script wrote armed in step 3, by `armed = true`
  a.ss:7: the script wrote p in step 5, by `p = 820`
step 11 (G = 100): One, entered in step 1 (G = 0); took no transition
the script stopped after this step
  b.sm:11: `n > 0` was true since step 7 (G = 60): n = 5
  b.sm:12: `10 < p < 20 or n > 7` was false since step 7 (G = 60)
    `10 < p < 20` was false since step 7 (G = 60): p = 1
    `n > 7` was false since step 7 (G = 60): n = 5, needs more than 2 more
  b.sm:12: -> Two was not taken, because `10 < p < 20 or n > 7` was false
what would have made a difference in this step:
  with p just above 10 (it was 1), the step would have taken the transition to Two
  with n = 8 (it was 5), the step would have taken the transition to Two
b.sm:12: One -> Two was never taken, and no step was nearer to taking it than this one
where the values come from:
  b.ss:9: the script wrote n in step 9, by `n = 5`
  b.ss:10: the script wrote p in step 9, by `p = 1`
step 11 (G = 100): One, entered in step 1 (G = 0); took no transition
the script stopped after this step
  b.sm:14: `held(p > 5, 40 ms)` was false since step 1 (G = 0); its condition was false when the step began
b.sm:14: One -> Three was never taken; step 3 (G = 20) was nearest to taking it:
  b.sm:14: `held(p > 5, 40 ms)` was false since step 1 (G = 0); its condition was true since G = 0, for 20 of 40
where the values come from:
  b.ss:10: the script wrote p in step 9, by `p = 1`
step 11 (G = 100): One, entered in step 1 (G = 0); took no transition
the script stopped after this step
  b.sm:15: `roll_avg(p, 4) > 9` was false since step 1 (G = 0): roll_avg(p, 4) = 6.75, needs more than 2.25 more
b.sm:15: One -> Four was never taken; step 1 (G = 0) was nearest to taking it:
  b.sm:15: `roll_avg(p, 4) > 9` was false: roll_avg(p, 4) = 9 from 1 of 4 samples, needs more
where the values come from:
  b.ss:10: the script wrote p in step 9, by `p = 1`
