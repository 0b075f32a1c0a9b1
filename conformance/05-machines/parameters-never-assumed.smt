spec 5.82  No stage assumes that a parameter has its default.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
F64 a = 2 @parameter @range 0 9
U8  n = 0 @parameter @range 0 200
bool on = false @parameter
F32 f = 1 @parameter @range -0.0 3
[define]
twice = a * 2
[Run]
.step
    x = 100 / a
    a == 2: x = 1
    on { y = twice }
    else: y = n + 100
    -> Next
[Next]
.step
    x = max(f, -1)
    n > 100: y = 7
    -> Last
[Last]
.step
    x = 1 / abs(f)
    y = floor(a)
-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: @assert x == 1
G == 0: @assert y == 100
G == 1: @assert x == 1
G == 1: @stop
-- other.ss --
[options]
delta_t 1
set a 0
set n 200
[all_states]
G == 0: @assert y == 300
G == 1: @assert y == 7
G == 1: @stop
-- third.ss --
[options]
delta_t 1
set a 4
set on true
set f 3
[all_states]
G == 0: @assert x == 25
G == 0: @assert y == 8
G == 1: @assert x == 3
G == 1: @stop
-- fourth.ss --
[options]
delta_t 1
set a 4.5
set f -0.0
[all_states]
G == 2: @assert x > 0
G == 2: @assert y == 4
G == 2: @stop
