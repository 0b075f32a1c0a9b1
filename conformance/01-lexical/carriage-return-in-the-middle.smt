spec 1.5  A carriage return that does not stand before a line end is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1+ 2   #! E0101
