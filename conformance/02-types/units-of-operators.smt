spec 2.32  Units are multiplied, divided, halved by sqrt and raised by pow; functions and statistics keep them.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit m
F64 t @unit s
F64 v @unit m/s
F64 area @unit m^2
F64 x

[Run] @safe
.step
    v = a / t
    a = v * t
    a = v / t                #! W0448 m/s^2
    a = sqrt(area)
    area = pow(a, 2)
    area = pow(a, 3)         #! W0448 m^3
    v = rate(a, 3)
    v = rate(v, 3)           #! W0448 m/s^2
    v = abs(prev(roll_avg(v, 3)))
    v = abs(prev(roll_avg(a, 3)))   #! W0448
    a = a * exp(t / t) * sign(v)
    v = a * log(x)           #! W0448
