spec 1.10   Names have no points.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = Tank.p          #! E0335 'Tank.p'
    x = p
