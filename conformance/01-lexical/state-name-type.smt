spec 1.24  A state must bear a name that could stand after an arrow; U8 is none.

-- app.sm --
[state_vector]
U64 G
U32 S

[U8]   #! E0306

[Other]
