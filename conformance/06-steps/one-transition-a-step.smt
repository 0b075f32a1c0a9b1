spec 6.11  A step makes one transition: through four states in four steps.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.entry -> B
[B]
.entry -> C
[C]
.entry -> D
[D]
.entry x = 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert S == 1
G == 1: @assert S == 2
G == 2: @assert S == 3 and x == 0
G == 3: @assert S == 4 and x == 1
G == 3: @stop
