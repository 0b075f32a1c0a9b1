spec 13.10  The same step is not an earlier one.
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
R1 "p before q"  never (q > 0) before (p > 0)      #! E1310 requirement R1 violated in step 2

-- app.ss --
[all_states]
G == 0: q = 0
G == 10: q = 1
G == 10: p = 1
G == 10: @stop
