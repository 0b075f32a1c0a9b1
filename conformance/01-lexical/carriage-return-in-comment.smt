spec 1.5  A carriage return within a comment is an error: an editor might show it as a line end and hide what follows.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1   # harmless  x = 2  #! E0101
