spec 5.11  A later local sees the stored value of an earlier one: truncated, saturated, rounded to F32.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
U8 a = 300
U16 b = a + 1
I8 c = 2.9
F64 d = c
F64 e = d * 4
F32 f = 0.1
F64 g = f
bool h = 0.5
F64 i = h + h

[Run]
.step
    x = b

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a == 255
    @assert b == 256
    @assert d == 2
    @assert e == 8
    @assert g == 0.10000000149011612
    @assert h
    @stop
}
