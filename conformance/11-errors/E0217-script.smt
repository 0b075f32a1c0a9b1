spec 8.11   Functions in a script are those of a machine.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y @read_only @alias why
[local]
F64 limit = 1 @read_only
F64 count = 1
[Hold]
.step
    x = y + limit + count
    x > 5: -> Abort
[Abort]
-- app.ss --
[options]
delta_t 10
[all_states]
sinh(x) > 1: x = 1            #! E0217
G == 0: x = abs(1, 2)         #! E0401
G == 1: x = roll_avg(x, y)    #! E0402
G == 2: x = roll_avg(x, 2.5)  #! E0404
G == 20: @stop
