spec 13.11  A C in the step with B, or in that with A, is not between them.
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
R1 "b"  never (q == 3) after (q >= 1 and q <= 2) without (q == 2 or q == 3)      #! E1310 in step 3

-- app.ss --
[all_states]
G == 0: q = 0
G == 10: q = 2
G == 20: q = 3
G == 20: @stop
