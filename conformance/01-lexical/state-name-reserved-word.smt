spec 1.24  A state must bear a name that could stand after an arrow; true is none.

-- app.sm --
[state_vector]
U64 G
U32 S

[true]   #! E0306

[Other]
