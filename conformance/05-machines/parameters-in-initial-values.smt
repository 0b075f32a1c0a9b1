spec 5.83  The initial value of a local cannot depend on a parameter; a definition can.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
F64 limit = 1 @parameter @range 0 2
F64 half = limit / 2              #! E0421 the initial value of 'half' cannot depend on the parameter 'limit'
F64 other = 3 @parameter @range 0 9
F64 third = other * 3 @parameter @range 0 9       #! E0421 the initial value of 'third' cannot depend on the parameter 'other'
[define]
twice = limit * 2
[Run]
.step
    x = half + twice + third
