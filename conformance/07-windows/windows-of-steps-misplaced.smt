spec 7.25  `steps` is the unit of a window's size only.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
[local]
F64 steps = 3
[Run]
.step
    a = abs(5 steps)              #! E0410
    a = roll_avg(3 steps, 5)      #! E0410
    a = steps + 1
    a = roll_avg(steps, 2)
    a = roll_avg(p, 2 + 1 steps)  #! E0313
    a = roll_avg(p, 20 ms steps)  #! E0313
