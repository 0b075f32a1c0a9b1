spec 5.35  The first true guard decides, and later ones do not count.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x
F64 y

[Run]
.step
    if a > 30: x = 3
    else if a > 20: x = 2
    else if a > 10 { x = 1 }
    else: x = 0
    a > 30 { y = 3 } else if a > 20 { y = 2 } else if a > 10: y = 1
    else {
        y = 0
    }

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: a = 5
G == 0: @assert x == 0 and y == 0
G == 1: a = 15
G == 1: @assert x == 1 and y == 1
G == 2: a = 25
G == 2: @assert x == 2 and y == 2
G == 3: a = 35
G == 3: @assert x == 3 and y == 3
G == 4: a = 10
G == 4: @assert x == 0 and y == 0
G == 5: a = 30
G == 5: @assert x == 2 and y == 2
G == 5: @stop
