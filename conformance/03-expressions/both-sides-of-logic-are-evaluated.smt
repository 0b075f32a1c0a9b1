spec 3.14, 7.4  A window on the right side of and or or takes its samples whatever the left side is.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
bool a
bool b

[Run]
.step
    a = 0 and roll_max(p, 9) > 0
    b = 1 or roll_max(p, 9) > 0
    x = (T == 2 and roll_max(p, 3)) * 10 + roll_max(p, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 8
G == 1: p = 2
G == 2: @assert x == 18 and not a and b
G == 2: @stop
