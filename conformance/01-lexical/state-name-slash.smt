spec 1.24  A state must bear a name that could stand after an arrow; pad/hold is none.

-- app.sm --
[state_vector]
U64 G
U32 S

[pad/hold]   #! E0305

[Other]
