spec 13.6, 13.8  An implication binds looser than or, and is true where its premise is not.
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
R1 "b is on"      always S == B or S == C implies on
R2 "in brackets"  never  not (S == B or S == C implies on)
R3 "argument"     always held(S == B implies on, 10 ms) or G < 20
R4 "q"            always S == C implies q > 0        #! E1310 requirement R4 violated in step 4

-- app.ss --
[all_states]
G == 0: p = 0
G == 10: p = 1
G == 20: p = 2
G == 20: q = 1
G == 30: q = 0
G == 30: @stop
