spec 2.30  A number and a value without a unit fit any unit.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit m
F64 b @unit ft
F64 x
bool on

[Run] @safe
.step
    a = 5
    a = x
    a = x * b
    a = b / x
    a = a + 3 * x
    a = on * a
    a = (b > 3) * b          #! W0448
    x = a
    x = b
