spec 5.84  Sizes of windows, times and counts cannot depend on a parameter.

-- app.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
U16 n = 2 @parameter @range 2 9
[define]
twice = n * 2                     #! E0422 declare 'n' with @read_only
[Run]
.step
    x = roll_avg(y, n)            #! E0422 the second argument of roll_avg cannot depend on the parameter 'n'
    x = x + roll_max(y, twice)
    x = x + held(y, n steps)      #! E0422 held
    x = x + rate(y, 1 + n)        #! E0422 rate
