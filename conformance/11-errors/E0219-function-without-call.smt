spec 3.18, 5.20   A function's name alone is no value.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x = abs + 1               #! E0219 abs(x)
    x = roll_avg              #! E0219 roll_avg(x, n)
    clamp > 5: x = clamp      #! E0219 clamp(x, lo, hi)
    x = atan2 + pow           #! E0219 atan2(y, x) #! E0219 pow(x, y)
    rising: x = 1             #! E0219 rising(c)
