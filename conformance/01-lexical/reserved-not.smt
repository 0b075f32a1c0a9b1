spec 1.11  not is reserved and cannot name a local.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 not = 1   #! E0354

[Run]
.step
    x = 1
