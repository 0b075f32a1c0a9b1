spec 5.61   A definition is an expression without arguments.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
I32 v
[define]
twice(x) = x * 2            #! E0392 as in twice_p = p * 2, and twice_p instead of twice(p)
hot(a, b) = a > b           #! E0392 as in hot_1 = (p + 1) > v, and hot_1 instead of hot(p + 1, v)
no(x) = x                   #! E0392 a definition has no arguments
[Hold]
.step
    twice(p) > 3: v = 1
    hot(p + 1, v): v = 2
