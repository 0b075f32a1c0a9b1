spec 1.22  x -1, x-1 and x - 1 are all x minus 1; a minus at the start of a value is its sign.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 a
F64 b
F64 c
F64 d
F64 e
F64 f

[Run]
.step
    a = x -1
    b = x-1
    c = x - 1
    d = -x
    e = x - -1
    f = x*-1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 7
    @assert a == 6
    @assert b == 6
    @assert c == 6
    @assert d == -7
    @assert e == 8
    @assert f == -7
    @stop
}
