spec 13.1  There are no sections.

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
[all_states]      #! E1311 leave it out
R1 "a" never p > 90
