spec 3.7  A sum of five hundred values from left to right.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  r1
F64  c1

[local]
F64  ka = 0.1 @read_only

[Run]
.step
    r1 = a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a
    c1 = ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka + ka

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.1
    @assert r1 == 50.00000000000044
    @assert c1 == 50.00000000000044
    @stop
}
