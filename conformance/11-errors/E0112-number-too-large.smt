spec 1.18, 1.19   A number too large for an F64 is an error; one too small is none.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1.7976931348623157e308
    x = 1e309                     #! E0112 too large
    x = 1.797693134862315808e308  #! E0112 too large
    x = 1e-999
