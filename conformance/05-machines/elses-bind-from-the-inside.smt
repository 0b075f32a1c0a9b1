spec 5.37  A second else belongs to the next conditional outward; braces close the conditionals inside them.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x
F64 y

[Run]
.step
    if a: if b: x = 1
    else: x = 2
    else: x = 3
    if a {
        if b: y = 1
    }
    else: y = 4

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = G >= 2
    y = 0
    b = G == 1 or G == 3
}
G == 0: @assert x == 3 and y == 4
G == 1: @assert x == 3 and y == 4
G == 2: @assert x == 2 and y == 0
G == 3: @assert x == 1 and y == 1
G == 3: @stop
