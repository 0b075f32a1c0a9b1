spec 5.1  @alias needs a name.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @alias   #! E0365

[Run]
.step
    x = 1
