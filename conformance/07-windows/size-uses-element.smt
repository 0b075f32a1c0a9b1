spec 7.1  The size cannot depend on a value that is known only in flight: p.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p

[Run]
.step
    x = roll_avg(p, p)   #! E0402
