spec 1.9  a<=b is one comparison, a<-b compares with -b, and a guard may touch the arrow after it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x
F64 y
F64 z

[Run]
.step
    x = a<=b
    y = a<-b
    z = a>=b==a<b

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = -5
    b = 3
    @assert x == 1
    @assert y == 1
    @assert z == 0
    @stop
}
