spec 13.18  A requirement that does not depend on the machine causes a warning.

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
R1 "a" always true                     #! W1304 R1 is never violated
R2 "b" never A before A                #! W1304 violated whenever its first condition is true
R3 "c" never false                     #! W1304
R4 "d" always S == A implies false     #! W1304 violated whenever its premise is true
R5 "e" always on leads to true within 1 s      #! W1304
R6 "f" never A after (false) without B #! W1304
