spec 7.1   The size of a window is known when compiling: no elements, no T, G, S.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
U16 n @alias m
[Hold]
.step
    x = roll_avg(x, n)        #! E0402 an element
    x = roll_avg(x, 2 * m)    #! E0402 an element
    x = roll_min(x, T)        #! E0402 the time in the state
    x = roll_max(x, G)        #! E0402
    x = roll_range(x, S + 1)  #! E0402
