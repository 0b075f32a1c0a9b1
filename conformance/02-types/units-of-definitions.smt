spec 2.37  A use of a definition has its unit.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit m
F64 b @unit ft
F64 x
[define]
metres = b * 0.3048 @unit m
same = (metres) @unit m
other = metres @unit psi     #! W0448
number = other * x

[Run] @safe
.step
    a = metres
    b = metres               #! W0448
    b = same                 #! W0448
    a = x
    a = number
