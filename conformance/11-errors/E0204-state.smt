spec 5.19, 5.20   A state is no value.
-- app.sm --
[state_vector]
U64 G
U32 S
[Hold]
.step
    Abort: -> Abort       #! E0204 'Abort' is a state: -> Abort goes there, S == Abort tests for it
    S == Hold: -> Abort
    Burn                  #! E0204 unknown element 'Burn'
    S = Hold              #! E0215 write -> Hold
    S = 1                 #! E0215 'S'
[Abort]
[Burn]
