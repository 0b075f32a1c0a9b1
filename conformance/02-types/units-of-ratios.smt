spec 2.36  percent is 0.01, and a value in gn counts how many times gn.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @unit percent
F64 n @unit 1
F64 f @unit N
F64 a @unit m/s^2
F64 g @unit gn
F64 r @unit rad
[define]
g0 = 9.80665 @unit m/s^2

[Run] @safe
.step
    p = n                    #! W0448 1 is 100 percent
    n = p / 100
    f = f * p                #! W0448
    f = f * p / 100
    g = a / g0
    n = g
    r = acos(g)
    g = a                    #! W0448
    r = acos(a)              #! W0449
