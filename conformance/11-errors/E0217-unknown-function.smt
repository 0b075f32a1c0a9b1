spec 3.17   An unknown function is an error, reported once.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 k = lenght(2)             #! E0217 'lenght'
[Hold]
.step
    x = roll_average(x, 10)   #! E0217 write roll_avg(x, n)
    x = sqroot(x)             #! E0217 'sqroot'
    x = absolut(1) + foor(2)  #! E0217 'absolut' #! E0217 did you mean 'floor'?
    x = sqroot(x) + foor(y) + k   #! E0204 'y'
    x = AND(x > 1, k)         #! E0217 write a and b
    x = square(x)             #! E0217 multiply
    x = Mod(x, 2)             #! E0217 remainder
