spec 6.14  An element may be assigned many times in a step; each reader sees the last value before it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[A]
.entry
    x = 1
    x = x + 1
.step
    y = x * 10
    x = x * 5
    x > 9: x = x + y
    -> B
.exit
    x = x + 1
    y = y + x
[B]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 31 and y == 51
G == 0: @stop
