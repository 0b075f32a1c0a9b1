spec 8.7   Items of a script must be in conditionals.

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
p = 600             #! E0380 in a script this must be under a condition
x = 1
G == 100: @stop
