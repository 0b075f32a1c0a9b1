spec 7.28, 7.8  A sample that is NaN enters as 0, and is false.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
bool b
[Run]
.step
    a = prev(p / p)
    b = rising(p / p) or falling(p / p)

-- app.ss --
[options]
delta_t 1
[all_states]
G == 1: p = 2
G == 0: @assert a == 0 and not b
G == 1: @assert a == 0 and b
G == 2: @assert a == 1 and not b
G == 3: p = 0
G == 3: @assert a == 1 and b
G == 3: @stop
