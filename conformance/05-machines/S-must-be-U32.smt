spec 5.4  S of another type is an error.

-- app.sm --
[state_vector]
U64 G
U8 S   #! E0211
F64 x

[Run]
.step
    x = 1
