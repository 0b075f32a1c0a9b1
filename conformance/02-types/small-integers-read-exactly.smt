spec 2.2  Whole numbers of up to 32 bits are read exactly, with their sign, of elements and of constants.

-- app.sm --
[state_vector]
U64 G
U32 S
I8 a
I16 b
I32 c
U8 d
U16 e
U32 f
F64 x
F64 y
F64 z

[local]
I8 const_a = -128 @read_only
I16 const_b = -32768 @read_only
I32 const_c = -2147483648 @read_only

[Run]
.step
    z = const_a + const_b + const_c
    x = a + b + c
    y = d + e + f

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = -128
    b = -32768
    c = -2147483648
    d = 255
    e = 65535
    f = 4294967295
    @assert x == -2147516544
    @assert y == 4295033085
    @assert z == x
    @stop
}
