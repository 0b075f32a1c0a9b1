spec 4.1  Regions can have elements of every type; a machine sees the ones it lists, in any region.

-- app.sv --
[Clock]
U64 G
U32 S

[Data]
I8 a
I16 b
I32 c
I64 d
U8 e
U16 f
F32 h
F64 i
bool j

[More]
F64 x

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
I8 a
bool j
I64 d

[Run]
.step
    x = a + j + d

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = -5
    j = 1
    d = 100
    @assert x == 96
    @stop
}
