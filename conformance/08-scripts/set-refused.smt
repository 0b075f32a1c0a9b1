spec 8.37  A name that is no parameter, a value outside the range and a parameter set twice are errors.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
F64 a = 1 @parameter @range 0 9
U8  n = 1 @parameter @range 0 200
bool b = false @parameter
F64 c = 4
[Run]
.step
    x = a + n + b
    c = c + x
-- app.ss --
[options]
delta_t 1
set a 9.5             #! E0424 cannot set parameter 'a' to 9.5: the value is above the range
set a -0.1            #! E0424 the value is below the range
set n 1.5             #! E0424 the value of an integer must be a whole number
set n 256             #! E0424 the value is above the range
set b 0.5             #! E0424 the value of a bool must be 0 or 1
set c 1               #! E0424 the machine has no such parameter
set x 1               #! E0424 the machine has no such parameter
set nothing 1         #! E0424 the machine has no such parameter
set a 2
set a 3               #! E0425 parameter 'a' is set twice
[all_states]
G == 0: @stop
