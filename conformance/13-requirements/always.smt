spec 13.8, 13.15  An always fails in the first step without it, and all that the step violates are reported.
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
R1 "p is small"  always p <= 10      #! E1310 requirement R1 violated in step 2 (G = 10
R2 "q is small"  always q <= 10
R3 "p is even"   always p != 11      #! E1310 requirement R3 violated in step 2

-- app.ss --
[all_states]
G == 0: p = 3
G == 10: p = 11
G == 20: p = 12
G == 20: @stop
