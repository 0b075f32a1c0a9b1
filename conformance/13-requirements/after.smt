spec 13.11  An after fails if no step since the last one with B had C.
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
R1 "not c after a without b"  never C after A without B       #! E1310 the last step with 'A' was at G = 40

-- app.ss --
[all_states]
G == 0: p = 0
G == 10: p = 1
G == 20: p = 2
G == 30: p = 0
G == 40: p = 2
G == 50: p = 2
G == 50: @stop
