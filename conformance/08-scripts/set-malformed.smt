spec 8.37  After set follow the name of a parameter and its value.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 a = 1 @parameter @range 0 9
[Run]
.step
    x = a
-- app.ss --
[options]
delta_t 1
set a = 3             #! E0373 there is no '=' between an option and its value
set                   #! E0374 'set' expects the name of a parameter and its value
set 3                 #! E0374 'set' expects the name of a parameter and its value
set a                 #! E0374 'set' expects the name of a parameter and its value
set a - true          #! E0374 'set' expects the name of a parameter and its value
set a x               #! E0374 'set' expects the name of a parameter and its value
[all_states]
G == 0: @stop
