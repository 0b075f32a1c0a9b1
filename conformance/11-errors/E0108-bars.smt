spec 3.1   |x| is written abs(x), which the edit does; a | between two values was meant as or.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
bool on
[Hold]
.step
    if |p| > 5: on = true                # the magnitude    #! E0108 write abs(p)
    x = |p - 1| + 1           #! E0108 write abs(p - 1)
    p > 5 | x > 3: on = false #! E0107 'or'
    |p - |x|| > 5: on = true  #! E0108 write abs(x)
    if |p| > 5 and |x| > 3: on = true    #! E0108 abs(p) #! E0108 abs(x)
