spec 5.6   T cannot be assigned.
-- app.sm --
[state_vector]
U64 G
U32 S
[Hold]
.step
    T = 0             #! E0216 time in the state
