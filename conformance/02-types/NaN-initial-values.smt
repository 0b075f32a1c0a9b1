spec 2.14  A local that begins as NaN begins as 0.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 d = 0/0
F32 f = -(0/0)
I16 i = sqrt(-1)
bool b = 1/0 - 1/0

[Run]
.step
    x = d + f + i + b

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert 1 / d == 1/0
    @assert 1 / f == 1/0
    @assert i == 0
    @assert b == 0
    @assert x == 0
    @stop
}

-- trace --
1 b false
1 d 0x0p+0
1 f 0x0p+0
1 i 0
