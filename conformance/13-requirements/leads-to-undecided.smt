spec 13.16  One that is undecided when the script stops is neither met nor violated.

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
R1 "q"  always p == 1 leads to q == 1 within 30 ms      #! W1301 'p == 1' was true at G = 10

-- app.ss --
[all_states]
G == 0: p = 0
G == 10: p = 1
G == 20: p = 1
G == 20: @stop
