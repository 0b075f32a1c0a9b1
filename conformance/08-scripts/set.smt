spec 8.37  A script sets parameters in [options], also in an included file, with a sign or a time.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
F64 a = 1 @parameter @range -9 9000
bool b = false @parameter
F64 set = 4
[Run]
.step
    x = a
    y = b
    set = set + 1
-- app.ss --
include "more.ss"
[options]
delta_t 1
set a -2.5
[all_states]
G == 0: @assert a == -2.5 and b and x == -2.5 and y
G == 0: @stop
-- time.ss --
[options]
delta_t 1
set a 1.5 s
[all_states]
G == 0: @assert a == 1500
G == 0: @stop
-- more.ss --
[options]
set b true
