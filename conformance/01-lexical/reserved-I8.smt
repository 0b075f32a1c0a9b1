spec 1.11  I8 is reserved and cannot name a local.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 I8 = 1   #! E0354

[Run]
.step
    x = 1
