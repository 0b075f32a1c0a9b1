spec 8.13   G and T are multiples of delta_t, and have no other values.
-- app.sm --
[state_vector]
U64 time @alias G
U32 S
F64 x
[local]
F64 begin = 25 @read_only
[Hold]
.step
    x > 5: -> Rest
[Rest]
-- app.ss --
[options]
delta_t 10
[all_states]
G == 15: x = 1                     #! W0702 'G' is never exactly 15: it advances by 10
time == begin: x = 1               #! W0702 'G' is never exactly 25
x > 0 and 7 == T: x = 2            #! W0702 'T' is never exactly 7
x > 0 or T == 2.5 { x = 2 }        #! W0702
G == 30: x = 3
G >= 15: x = 4
not (G == 15): x = 4
G != 15: x = 4
G == x: x = 5
G == 15: @assert x > 7             #! W0750
G == 35: @stop                     #! W0702
G == 90: @stop
