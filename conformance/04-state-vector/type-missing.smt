spec 4.1  An element needs a type.

-- app.sv --
[R]
F64 a
b   #! E0352
