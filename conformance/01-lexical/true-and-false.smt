spec 1.20  true is 1 and false is 0, in arithmetic too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
bool c

[Run]
.step
    a = true + true
    b = false * 5 - true
    c = true

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a == 2
    @assert b == -1
    @assert c == true
    @assert c == 1
    @stop
}
