spec 1.6  The last line of each file needs no line end.

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 1
    @stop
}

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1