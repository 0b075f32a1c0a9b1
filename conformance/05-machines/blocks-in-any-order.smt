spec 5.25  The order of the blocks in the file means nothing.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.exit
    x = x * 10 + 3
.step
    x = x * 10 + 2
    -> B
.entry
    x = x * 10 + 1

[B]

-- app.ss --
[options]
delta_t 1

[all_states]
true: @assert x == 123
true: @stop
