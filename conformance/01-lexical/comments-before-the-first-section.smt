spec 1.34  Comments and empty lines may stand there.

-- app.sm --
# A machine.

[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1

-- app.ss --

  # A script.
[options]
delta_t 1

[all_states]
true {
    @assert x == 1
    @stop
}
