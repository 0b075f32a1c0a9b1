spec 2.39  N*m is J, and rad/s is Hz.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 e @unit J
F64 t @unit N*m
F64 f @unit Hz
F64 w @unit rad/s

[Run] @safe
.step
    e = t
    f = w
