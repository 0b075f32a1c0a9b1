spec 5.47   @range is followed by two numbers.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only @range 3, 41.5       #! E0377 write @range 3 41.5
F64 q @read_only @range -3..41        #! E0377 write @range -3 41
F64 r @read_only @range [3 41]        #! E0377 write @range 3 41
[local]
const F64 lim = 4                     #! E0329 write F64 lim = 4 @read_only
[Hold]
.step
    p > 1: -> Hold
