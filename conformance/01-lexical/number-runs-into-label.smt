spec 1.16  A number with a point directly followed by letters is an error and not a number before a label.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.entry x = 5.step   #! E0114
