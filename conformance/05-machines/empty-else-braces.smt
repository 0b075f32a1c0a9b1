spec 5.39  Empty braces after else too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x

[Run]
.step
    if a: x = 1
    else { }   #! W0502

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0
    @assert x == 0
    @stop
}
