# No finding: a machine with one state, and a state that only time ends.
warn no-all missing-way-out

-- app.sm --
[state_vector]
U64 G
U32 S
bool lamp
[Blink]
.step
    lamp = T > 500
