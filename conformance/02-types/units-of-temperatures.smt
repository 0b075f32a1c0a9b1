spec 2.34  degC, degF and K, and the differences of temperatures.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 c @unit degC
F64 c2 @unit degC
F64 f @unit degF
F64 k @unit K
F64 j @unit J
F64 cp @unit J/K
[local]
F64 zero = 273.15 @unit K @read_only

[Run] @safe
.step
    k = c + 273.15
    c = k - 273.15
    f = c * 1.8 + 32
    c = (f - 32) / 1.8
    k = c                    #! W0448 0 degC is 273.15 K
    c = f                    #! W0448 0 degF is -17.7778 degC
    k = c - c2
    c = c - c2
    c = c + k
    c = k - c2               #! W0448
    c = k - zero
    j = cp * (c - c2)
    j = cp * c
    j = cp * (f - f)         #! W0448
