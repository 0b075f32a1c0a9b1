spec 13.12, 13.13  The same step counts, and so does one exactly t later.

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
R1 "same step"  always p > 0 leads to p > 0 and q == 0 within 0 ms
R2 "later"      always p == 1 leads to S == C within 2 * 10.4
R3 "implied"    always p == 1 implies q == 1 leads to p < 9 within 10 ms

-- app.ss --
[all_states]
G == 0: p = 0
G == 10: p = 1
G == 20: p = 2
G == 30: p = 2
G == 40: p = 0
G == 40: @stop
