spec 8.7   A conditional of a script is not empty.

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
G == 0 { }          #! E0384 this conditional is empty
G == 100: @stop
