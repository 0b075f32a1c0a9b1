spec 13.11  A and B in one step: the last step with B is an earlier one.

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
R1 "ok"  never (q >= 2) after (q == 2) without (q == 1)

-- app.ss --
[all_states]
G == 0: q = 2
G == 10: q = 1
G == 20: q = 2
G == 30: q = 1
G == 40: q = 3
G == 50: q = 0
G == 50: @stop
