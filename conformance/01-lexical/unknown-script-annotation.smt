spec 1.26  In a script too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 y

[Run]
.step
    y = 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @asert y == 1   #! E0340
G == 0: @stop
