spec 1.11  else is reserved and cannot name a local.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 else = 1   #! E0354

[Run]
.step
    x = 1
