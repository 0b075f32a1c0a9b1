spec 2.35  Angles are plain numbers; sin, cos and tan need radians, and the inverse functions return them.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 d @unit deg
F64 r @unit rad
F64 w @unit rad/s
F64 l @unit m
F64 v @unit m/s
F64 x

[Run] @safe
.step
    x = sin(r)
    x = sin(d)               #! W0449 sin needs radians, but 'd' has the unit deg
    x = cos(d * 0.01745)
    x = tan(l)               #! W0449
    r = atan2(l, l)
    d = atan2(l, l)          #! W0448 1 rad is 57.2958 deg
    d = acos(x) * 57.2958
    r = asin(d)              #! W0449 asin needs a plain number
    x = pow(2, l)            #! W0449
    v = w * l
