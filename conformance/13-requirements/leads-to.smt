spec 13.12  The condition has to follow within the time, and the last step that could have it decides.
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
R1 "on"  always p > 0 leads to S == C within 25 ms      #! E1310 'p > 0' was true at G = 10, and 'S == C' was not true up to G = 30

-- app.ss --
[all_states]
G == 0: p = 0
G == 10: p = 1
G == 20: p = 1
G == 30: p = 1
G == 40: p = 2
G == 50: p = 2
G == 50: @stop
