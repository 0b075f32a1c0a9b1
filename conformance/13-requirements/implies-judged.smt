spec 13.8, 13.17  An implication is judged only where its premise is true, and a warning names one that never was.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
F64 q @read_only
bool on

[define]
high = p > 10

[A]
.step
    on = false
    p == 1: -> B
    p == 2: -> C

[B]
.step
    on = true
    p == 0: -> A
    p == 2: -> C

[C]
.step
    on = true
    p == 0: -> A
    p == 1 and not high: -> B

-- app.rq --
R1 "b is on"   always S == B implies on          #! W1300 never judged: b is on
R2 "always"    always (S == B or S == A)
R3 "premise"   always (S == B implies on)        #! W1300

-- app.ss --
[all_states]
G == 0: p = 0
G == 10: p = 0
G == 20: p = 0
G == 20: @stop
