# A machine of one state does one thing for ever; a state that time alone ends has a way out.
warn no-all missing-way-out

-- app.sm --
[state_vector]
U64 G
U32 S
bool lamp
[Blink]
.step
    lamp = T > 500
