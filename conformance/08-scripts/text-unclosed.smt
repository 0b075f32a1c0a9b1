spec 8.31  A text of a script ends on its line.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x = 1
-- app.ss --
include "plant.ss                           #! E0344
[options]
delta_t 10
[all_states]
G == 0: @assert x < 3 "abc                  #! E0121
G == 0: @fail "abc                          #! E0121
G == 0: @expect x > 3 within 20 ms "abc     #! E0121
G == 0: @print x "abc                       #! E0121
G == 10: @stop
