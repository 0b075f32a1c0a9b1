spec 3.32  What the user means is certain only for `S == A or B` alone.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Idle]
.step
    S == Idle or Run: x = 1              #! E0204 write S == Run
    S != Idle or Hold: x = 2             #! E0204 S == Hold tests for it
    S == Idle and Coast: x = 3           #! E0204 S == Coast tests for it
    x > 3 and S == Idle or Burn: x = 4   #! E0204 S == Burn tests for it
[Run]
[Hold]
[Coast]
[Burn]
