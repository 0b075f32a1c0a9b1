spec 2.2  The top bit of an unsigned element is no sign.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 a
U16 b
U32 c
U64 d
bool p

[Run]
.step
    p = a > 0 and b > 0 and c > 0 and d > 0

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 255
    b = 65535
    c = 4294967295
    d = 1.8e19
    @assert p
    @assert c == 4294967295
    @assert d > 1e19
    @stop
}
