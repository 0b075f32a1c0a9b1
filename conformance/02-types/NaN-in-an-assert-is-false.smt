spec 2.14  An assert of NaN fails.
expect fail

-- app.sm --
[state_vector]
U64 G
U32 S
F64 z

[Run]
.step
    z = 0

-- app.ss --
[options]
delta_t 1

[all_states]
true: @assert z / z   #! E0750
true: @stop
