spec 5.14, 8.10  A script may write a read-only local, and the machine sees the new value.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 limit = 5 @read_only
F64 other = 7 @read_only
F64 twice = limit * 2

[Run]
.step
    x = limit * 10 + other

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 57
G == 1: limit = 6   #! W0701
G == 1: @assert x == 67
G == 2: @assert x == 67 and limit == 6 and twice == 10
G == 2: @stop
