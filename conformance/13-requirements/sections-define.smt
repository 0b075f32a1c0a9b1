spec 13.1  Definitions belong to the machine. Their names are not reported again.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool valve

[A]
.step
    p > 1: -> B
[B]
.step
    p < 1: -> A

-- app.rq --
[define]                           #! E1311 write them in its section [define]
high = p > 10
R1 "p is small"   never high
