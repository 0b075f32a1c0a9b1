spec 2.2  An F32 is read as exactly the value it stores: that nearest to 0.1 is not the F64 0.1.

-- app.sm --
[state_vector]
U64 G
U32 S
F32 f
F64 x
F64 y

[Run]
.step
    x = f
    y = f * 10

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    f = 0.1
    @assert x != 0.1
    @assert x == 0.10000000149011612
    @assert y == 1.0000000149011612
    @stop
}
