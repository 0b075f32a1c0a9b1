spec 13.4  In the first step prev is the same sample, nothing rises, a window has one sample, and a premise counts; a window longer than the run is never full.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool on

[A]
.step
    on = p > 5
    p == 3: -> A

-- app.rq --
R1 "no edge at the start"     never  rising(p == 1)
R2 "none that falls"          always not falling(p == 1) or p == 3
R3 "the same sample"          always G == 0 implies prev(p) == p
R4 "longer than the run"      never  held(p > 0, 10 s)
R5 "more steps than the run"  never  held(p > 0, 500 steps)
R6 "one sample is enough"     always G == 0 implies roll_max(p, 500) == 1 and roll_avg(p, 500) == 1
R7 "a premise at once"        always p == 1 leads to G == 20 within 20 ms
R8 "the same step counts"     always p == 1 leads to not on within 0
R9 "T begins again"           always p == 3 and G > 30 implies T == 0
R10 "the one between"         never  (p == 3 and G > 30) after (p == 1) without (p == 3)
R11 "not yet"                 never  (p == 3) before (p == 1)

-- app.ss --
[all_states]
G == 0: p = 1
G == 30: p = 3
G == 60: @stop
