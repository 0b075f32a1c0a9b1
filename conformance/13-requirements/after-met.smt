spec 13.11  A C between the last B and A is enough, and without a B nothing is judged.

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
R1 "only through b"  never C after A without B
R2 "q"               never (q == 3) after (q == 1) without (q == 2)
R3 "never there"     never C after (q == 9) without B           #! W1300

-- app.ss --
[all_states]
G == 0: p = 0
G == 0: q = 3
G == 10: p = 1
G == 10: q = 1
G == 20: q = 2
G == 30: q = 0
G == 40: q = 3
G == 50: p = 2
G == 60: @stop
