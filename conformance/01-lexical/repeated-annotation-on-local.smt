spec 1.26  The same annotation twice on one local is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 y

[local]
F64 k = 1 @read_only @read_only   #! E0361

[Run]
.step
    y = k
