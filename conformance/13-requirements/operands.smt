spec 13.9  An operand without parentheses is the name of a state.

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
R1 "a"  never on before B                 #! E1309 'on' is no state
R2 "b"  never q > 1 before B              #! E1304 write (q > 1)
R3 "c"  never B after high without C      #! E1309 'high'
R4 "d"  never B after D without C         #! E0501 unknown state 'D'
R5 "e"  never B after A without q == 1    #! E1304 with 'without'
R6 "f"  never (B) before C                #! E0204 is a state
R7 "g"  never (high) before (q == 1 or on)
