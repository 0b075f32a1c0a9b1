spec 5.77, 5.81  A parameter has its default until a script sets it, and keeps its value through transitions.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
bool c
[local]
F64 limit = 450 @parameter @range 150 1000
F32 gain = 0.1 @parameter @range -1.5 1.5
I16 offset = -3 @parameter @range -5 5
U64 large = 9007199254740992 @parameter @range 0 18446744073709549568
bool on = true @parameter
[Run]
.step
    x = limit
    y = gain + offset
    c = on
    -> Next
[Next]
.step
    x = large
    y = limit + 1
-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: @assert x == 450
G == 0: @assert y == 0.100000001490116119384765625 - 3
G == 0: @assert c
G == 0: @assert limit == 450
G == 1: @assert x == 9007199254740992
G == 1: @assert y == 451
G == 1: @stop
-- set.ss --
[options]
set limit 150
set gain -1.5
delta_t 1
set offset 5
set large 18446744073709549568
set on false
[all_states]
G == 0: @assert x == 150
G == 0: @assert y == 3.5
G == 0: @assert not c
G == 0: @assert gain == -1.5
G == 1: @assert x == 18446744073709549568
G == 1: @assert y == 151
G == 1: @stop
