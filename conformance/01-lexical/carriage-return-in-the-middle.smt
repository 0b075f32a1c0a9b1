spec 1.5  A carriage return is an error unless a line end follows it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1+ 2   #! E0101
