spec 1.21  ! is another spelling of not.

-- app.sm --
[state_vector]
U64 G
U32 S
bool p
F64 x
F64 y
F64 z

[Run]
.step
    x = !p
    y = !(1 > 2)
    z = !!5

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    p = true
    @assert x == 0
    @assert y == 1
    @assert z == 1
    @stop
}
