spec 5.21  [options] belongs to state vectors and scripts.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[options]   #! E0303
lock

[Run]
.step
    x = 1
