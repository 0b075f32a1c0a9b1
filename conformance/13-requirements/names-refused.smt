spec 13.3  Names that the machine does not have are errors.

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
R1 "a"  never presure > 3             #! E0204
R2 "b"  never S == D                  #! E0501
R3 "c"  never p > 1 and A             #! E0204 is a state
R4 "d"  always nope(p)                #! E0217
R5 "e"  always p > 1
