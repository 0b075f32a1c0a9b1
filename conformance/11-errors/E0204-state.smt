spec 5.19, 5.20   A state is no value.
-- app.sm --
[state_vector]
U64 G
U32 S
[Hold]
.step
    Abort: -> Abort       #! E0204 'Abort' is a state
[Abort]
