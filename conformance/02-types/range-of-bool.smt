spec 2.1  A bool has the values true and false only.

-- app.sm --
[state_vector]
U64 G
U32 S
bool b
F64 x

[Run]
.step
    b = 7
    x = b + b

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert b == 1
    @assert x == 2
    @stop
}
