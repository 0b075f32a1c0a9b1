spec 4.1  A type that does not exist is an error.

-- app.sv --
[R]
F64 a
F16 b   #! E0351
