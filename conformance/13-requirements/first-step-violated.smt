spec 13.4  The first step can violate a requirement: it has no earlier step, one sample in each window, and a time of 0.
expect fail
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
R1 "no earlier step"      never  (p == 1) before (G == 0)          #! E1310 in step 1
R2 "the same sample"      always prev(p) != p                      #! E1310 in step 1
R3 "within 0"             always p == 1 leads to on within 0       #! E1310 in step 1
R4 "one sample"           always roll_min(p, 500) != 1             #! E1310 in step 1
R5 "a window of one"      never  held(p == 1, 1 steps)             #! E1310 in step 1
R6 "the first time"       never  G == 0 and T == 0 and S == A      #! E1310 in step 1

-- app.ss --
[all_states]
G == 0: p = 1
G == 60: @stop
