spec 1.26  The same annotation twice on one element is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only @read_only   #! E0361
F64 y

[Run]
.step
    y = x
