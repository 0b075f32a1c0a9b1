spec 1.39  A time in a product or quotient, in parentheses or by a definition.
warn

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 v

[define]
tick = 20 ms
same = (tick)
sum = tick + 1

[Run]
.step
    x = x + v * (20 ms)          #! W0423 20 ms is the number 20 in a product or quotient
    x = x + ((20 ms)) * v        #! W0423
    x = x + v * tick             #! W0423 'tick' is the number 20 in a product or quotient
    x = x + v / (same)           #! W0423
    x = v * sum
    x = v - tick
