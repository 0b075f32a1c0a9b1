spec 8.31, 8.55  The quotation mark " alone begins and ends a text, which cannot contain one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x = 2
-- app.ss --
[options]
delta_t 10
[data]
file 'flight.csv'                          #! E0122
time “t” ms                                #! E0122
x = "p"
[all_states]
G == 0: @assert x < 3 'abc'                #! E0122
G == 0: @fail ‘abc’                        #! E0122
G == 0: @print x "3.5\" pipe"              #! E0123
G == 0: @assert x < 3 "ends with \""       #! E0123
G == 0: @assert x < 3 "C:\"
G == 10: @stop
