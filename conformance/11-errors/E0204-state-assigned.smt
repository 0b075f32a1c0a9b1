spec 5.19   A change of state needs a transition, not an assignment.

-- app.sm --
[state_vector]
U64 G
U32 tankState @alias S
U8 mode
F64 p @read_only
[Idle]
.step
    p > 50: state = Abort           #! E0204 to go to the state 'Abort', write -> Abort
    p > 60: tankState = Abort       #! E0215 write -> Abort
    p > 70: S = 2                   #! E0215 write -> Abort
    p > 80: S = mode                #! E0215 -> State
    mode = Abort                    #! E0204 'Abort' is a state
[Abort]
