spec 13.3, 13.4  Conditions use all names of the machine, and sample after the step what it left.
expect fail
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
R1 "definition"  always high or p <= 10
R2 "alias"       always time == G and state == S
R3 "T"           always S == A and T > 20 ms implies not on
R4 "rising"      always rising(on) implies S == B and prev(S == A)
R5 "window"      never  roll_max(p, 20 ms) > 1        #! E1310 roll_max(p, 20 ms) = 2

-- app.ss --
[all_states]
G == 0:   p = 0
G == 50:  p = 1
G == 90:  p = 2
G == 200: @stop
