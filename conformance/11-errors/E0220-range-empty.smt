spec 5.47   The lowest value of a range comes first.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @range 1.5 -2       #! E0220 the range of 'x' is empty: 1.5 is more than -2
F64 y @range -2 -1.5
[A]
.step
    y = x
