spec 5.37  After "if a: if b: x = 1" an else belongs to "if b"; here a is 1 and b is 1.

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
    a: b: y = 1 else: y = 2

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    b = 1
    @assert x == 1
    @assert y == 1
    @stop
}
