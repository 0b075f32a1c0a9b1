spec 3.32  Elsewhere the name of a state is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Idle]
.step
    S == Idle or Run: x = 2         #! E0204 write S == Run
    x = Steady                      #! E0204 S == Steady tests for it
    S < Coast: x = 3                #! E0204 S == Coast
    x == Burn: x = 4                #! E0204 S == Burn
    S == Burning: x = 5             #! E0501 unknown state 'Burning'
[Run]
[Steady]
[Coast]
[Burn]
