spec 13.1, 13.2, 13.7, 13.14  A never is judged after every step, before the asserts of the step.
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
R1 "p is small"
    never  p > 10      #! E1310 requirement R1 violated in step 3 (G = 20, state A): p is small

-- app.ss --
[all_states]
G == 0: p = 0
G == 10: p = 5
G == 20: p = 11
G == 20: @assert false      #! E0750 step 3
G == 20: @stop
