spec 8.1   There is no sign between an option and its value.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p
-- app.ss --
[options]
delta_t = 10        #! E0373 '='
init_state: Hold    #! E0373 ':'
[all_states]
G == 100: @stop
