spec 4.1  An element needs a name.

-- app.sv --
[R]
F64 a
F64   #! E0353
[Q]
F64 b
