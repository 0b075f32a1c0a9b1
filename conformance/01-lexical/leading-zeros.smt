spec 1.15  Leading zeros change nothing; there is no octal.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c
F64 d

[Run]
.step
    a = 007.5
    b = 010
    c = 0099
    d = 00

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a == 7.5
    @assert b == 10
    @assert c == 99
    @assert d == 0
    @stop
}
