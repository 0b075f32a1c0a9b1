spec 8.24, 8.22  A name of a definition cannot be declared in [local], nor the name of a variable in [define]; each reads the other.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[define]
high = x > 5
[Hold]
.step
    high: x = 0
-- app.ss --
[options]
delta_t 10
[local]
F64 high = 1        #! E0201 'high' is already used: it is a definition of the machine
F64 level = 2
[define]
level = x + 1       #! E0201 'level'
above = level > 2
[all_states]
G == 0: @assert not above
G == 10: @stop
