spec 5.1  Elements may bear @read_only and @alias, together and in either order.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @read_only @alias b
F64 c @alias d @read_only
F64 e

[Run]
.step
    e = a + b + c + d

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 3
    d = 4
    @assert e == 14
    @stop
}
