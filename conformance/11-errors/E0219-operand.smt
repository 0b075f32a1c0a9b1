spec 3.9   A function's argument needs parentheses; the edit writes them around one name or number.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
bool on
[Hold]
.step
    abs p > 5: on = true      #! E0219
    if abs p > 5: on = true   #! E0219
    x = sqrt x + 1            #! E0219
    x = sqrt 5                #! E0219
    x = max p, x              #! E0219
    x = abs -p                #! E0219
    x = abs(p) + sqrt(x)
