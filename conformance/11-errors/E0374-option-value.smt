spec 8.1   delta_t has one number without a sign, init_state a name.

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
delta_t -10         #! E0374 '-'
init_state 1        #! E0374 the number 1
delta_t 5
[all_states]
G == 100: @stop
