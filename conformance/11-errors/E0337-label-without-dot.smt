spec 1.25   A label has a point.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
step:               #! E0337 '.step'
    x = p
[Idle]
entry               #! E0337 '.entry'
    x = p
