spec 5.65  What is allowed depends on the place of the use.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[define]
high = x > 3                       #! E0406
mean = roll_avg(x, 3)              #! E0409
size = x + 2                       #! E0402
[local]
F64 a = high
F64 b = mean
[Run]
.step
    high: x = roll_avg(x, size)
    x = mean + a + b
