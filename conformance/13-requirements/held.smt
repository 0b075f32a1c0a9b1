spec 13.4  held counts what the steps left.
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
R1 "on"  always held(on, 30 ms) implies p != 7
R2 "on"  never  held(on, 3 steps) and q == 1           #! E1310 in step 5

-- app.ss --
[all_states]
G == 0: p = 1
G == 20: q = 0
G == 30: q = 0
G == 40: q = 1
G == 60: @stop
