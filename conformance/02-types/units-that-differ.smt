spec 2.29  Sums, comparisons, assignments, arguments, initial values and definitions need one unit.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit m
F64 b @unit ft
F64 t @unit s
F64 x
[local]
F64 l = 3 @unit ft
F64 k = l @unit m           #! W0448

[define]
d = a @unit ft              #! W0448 'd' has the unit ft, but 'a' has the unit m
e = l @unit ft

[Run] @safe
.step
    a = b                    #! W0448 'a' has the unit m, but 'b' has the unit ft
    x = a + b                #! W0448 1 ft is 0.3048 m
    x = a - t                #! W0448 they measure different things
    x = a < b                #! W0448
    x = 1 < a < t            #! W0448
    x = max(a, b)            #! W0448
    x = clamp(a, 0, b)       #! W0448
    x = hypot(a, b)          #! W0448
    x = atan2(a, b)          #! W0448
    x = d + e
