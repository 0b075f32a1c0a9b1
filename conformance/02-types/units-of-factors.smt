spec 2.33  Which numbers are conversions, which can have a unit, and which are neither.
warn no-all units unit-factor

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit m
F64 b @unit ft
F64 v @unit m/s

[Run] @safe
.step
    a = b * 0.3048
    a = b * 0.31
    a = b / 3.28
    a = b * 0.5              #! W0448
    a = b / 3                #! W0448
    a = b * 3.28             #! W0448
    a = b * 0.4              #! W0450 unless its number has a unit
    a = v * 0.02             #! W0450 the number then has the unit s
    a = v                    #! W0448
