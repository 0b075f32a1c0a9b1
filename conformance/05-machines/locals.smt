spec 5.9  Locals of every type have the initial value they are given.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
I8 a = -1
I16 b = 2
I32 c = 3
I64 d = 4
U8 e = 5
U16 f = 6
U32 g = 7
U64 h = 8
F32 i = 9.5
F64 j = 22.25
bool k = true

[Run]
.step
    x = a + b + c + d + e + f + g + h + i + j + k

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 66.75
    @stop
}
