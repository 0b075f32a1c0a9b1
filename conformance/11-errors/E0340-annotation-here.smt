spec 8.6   A script knows @assert and @stop only.

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
delta_t 10
[all_states]
true: @asert x == p     #! E0340 did you mean '@assert'?
G == 100: @stop
