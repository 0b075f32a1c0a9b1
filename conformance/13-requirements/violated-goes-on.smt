spec 13.15  A violation does not end the run: later steps violate other requirements, each is reported once, and asserts are judged.
expect fail
-- app.sm --
[options]
step 10 ms

[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool on

[A]
.step
    on = false
    p > 5: -> B

[B]
.step
    on = true

-- app.rq --
R1 "p is small"       never p > 10                          #! E1310 requirement R1 violated in step 2 (G = 10, state A)
R2 "never on"         never on                              #! E1310 requirement R2 violated in step 3 (G = 20, state B)
R3 "on is answered"   always on leads to p == 0 within 10 ms     #! E1310 requirement R3 violated in step 4 (G = 30
R4 "stays"            always S == B implies on

-- app.ss --
[all_states]
G == 0: p = 3
G == 10: p = 11
G == 10: @assert state A
G == 20: p = 12
G == 50: @assert state A      #! E0750 step 6 (G = 50, state B)
G == 90: @stop
