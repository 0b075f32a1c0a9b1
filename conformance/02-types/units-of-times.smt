spec 2.31  T, G and times count the unit of the machine.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
U64 since @unit us
[options]
time_unit us

[local]
F64 delay = 3 ms @unit us
F64 late = 2 @unit s

[Run] @safe
.step
    x = T > delay
    x = T > late             #! W0448 1 s is 1e+06 us
    x = G - since > 3 ms
    late = 5 s               #! W0448 '5 s' has the unit us
    x = rate(x, 3) > late
