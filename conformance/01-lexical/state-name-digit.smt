spec 1.24  A state must bear a name that could stand after an arrow; 1st is none.

-- app.sm --
[state_vector]
U64 G
U32 S

[1st]   #! E0305

[Other]
