spec 8.22  A definition of a script has a name of its own.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
[define]
high = p > 5
[Run]
.step
    x = high
-- app.ss --
[options]
delta_t 1
[define]
high = 3                 #! E0201 it is a definition
p = 4                    #! E0201 it is an element
[all_states]
true: high = G           #! E0223
G == 11: @assert x == 1
G == 11: @stop
