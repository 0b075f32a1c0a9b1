# A parameter has one value in a whole run: what would have been different is tried in the whole script, within its range.
args why a.sm a.ss --to=Abort
args why a.sm a.ss --to=Abort --at-step=2
args why a.sm a.ss --to=Abort --set=limit=840 --format=json
args why a.sm low.ss --to=Abort

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only

[local]
F64 limit = 825 @parameter @range 700 900

[Fill]
.step
    p > limit: -> Abort

[Abort] @abort @safe
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 650
G == 20: p = 800
G == 40: p = 790
G == 50: @stop
-- low.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 650
G == 50: @stop
-- stdout --
step 6 (G = 50): Fill, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:13: `p > limit` was false since step 1 (G = 0): p = 790, limit = 825, needs more than 35 more
what would have made a difference in this step:
  with p just above 825 (it was 790), the step would have taken the transition to Abort
a.sm:13: Fill -> Abort was never taken; step 3 (G = 20) was nearest to taking it:
  a.sm:13: `p > limit` was false since step 1 (G = 0): p = 800, limit = 825, needs more than 25 more
  what would have made a difference in this step:
    with p just above 825 (it was 800), the step would have taken the transition to Abort
    with limit just below 800 in the whole run (it was 825), the step would have taken the transition to Abort
where the values come from:
  a.ss:6: the script wrote p in step 5, by `p = 790`
  a.sm:9: limit is a parameter
step 2 (G = 10): Fill, entered in step 1 (G = 0); took no transition
  a.sm:13: `p > limit` was false since step 1 (G = 0): p = 650, limit = 825, needs more than 175 more
what would have made a difference in this step:
  with p just above 825 (it was 650), the step would have taken the transition to Abort
where the values come from:
  a.ss:4: the script wrote p in step 1, by `p = 650`
  a.sm:9: limit is a parameter
{"smc-why":1,"step":6,"G":50,"lines":[
{"kind":"step","depth":0,"text":"step 6 (G = 50): Fill, entered in step 1 (G = 0); took no transition","step":6},
{"kind":"remark","depth":0,"text":"the script stopped after this step"},
{"kind":"guard","depth":1,"text":"`p > limit` was false since step 1 (G = 0): p = 790, limit = 840, needs more than 50 more","file":"a.sm","line":13,"column":5,"value":false,"gap":50,"since":1},
{"kind":"heading","depth":0,"text":"what would have made a difference in this step:"},
{"kind":"change","depth":1,"text":"with p just above 840 (it was 790), the step would have taken the transition to Abort","variable":"p","value":"840.0000000000001","was":"790","whole_run":false,"transition":"Abort"},
{"kind":"nearest","depth":0,"text":"Fill -> Abort was never taken; step 3 (G = 20) was nearest to taking it:","file":"a.sm","line":13,"column":16,"step":3},
{"kind":"guard","depth":1,"text":"`p > limit` was false since step 1 (G = 0): p = 800, limit = 840, needs more than 40 more","file":"a.sm","line":13,"column":5,"value":false,"gap":40,"since":1},
{"kind":"heading","depth":1,"text":"what would have made a difference in this step:"},
{"kind":"change","depth":2,"text":"with p just above 840 (it was 800), the step would have taken the transition to Abort","variable":"p","value":"840.0000000000001","was":"800","whole_run":false,"transition":"Abort"},
{"kind":"change","depth":2,"text":"with limit just below 800 in the whole run (it was 840), the step would have taken the transition to Abort","variable":"limit","value":"799.9999999999999","was":"840","whole_run":true,"transition":"Abort"},
{"kind":"heading","depth":0,"text":"where the values come from:"},
{"kind":"origin","depth":1,"text":"the script wrote p in step 5, by `p = 790`","file":"a.ss","line":6,"column":10,"step":5},
{"kind":"origin","depth":1,"text":"limit is a parameter","file":"a.sm","line":9,"column":5}
]}
step 6 (G = 50): Fill, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:13: `p > limit` was false since step 1 (G = 0): p = 650, limit = 825, needs more than 175 more
what would have made a difference in this step:
  with p just above 825 (it was 650), the step would have taken the transition to Abort
a.sm:13: Fill -> Abort was never taken, and no step was nearer to taking it than this one
where the values come from:
  low.ss:4: the script wrote p in step 1, by `p = 650`
  a.sm:9: limit is a parameter
