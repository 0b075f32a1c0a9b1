spec 5.8  An alias is a second name, not an element of its own that might be listed again.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @alias p
F64 p   #! E0201

[Run]
.step
    x = 1
