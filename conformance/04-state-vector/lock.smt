spec 4.2  [options] can request a lock; it does not change the behaviour of a machine.

-- app.sv --
[options]
lock

[R]
U64 G
U32 S
F64 x

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 1
    @stop
}
