spec 1.22  The same applies to plus.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 a
F64 b
F64 c

[Run]
.step
    a = x +1
    b = +x
    c = x - +1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 7
    @assert a == 8
    @assert b == 7
    @assert c == 6
    @stop
}
