spec 1.24  A state needs a name that could follow an arrow; pad/hold is not one.

-- app.sm --
[state_vector]
U64 G
U32 S

[pad/hold]   #! E0305

[Other]
