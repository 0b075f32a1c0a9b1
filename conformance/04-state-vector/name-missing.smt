spec 4.1  An element needs a name.

-- app.sv --
[R]
F64 a
F64
[Q]   #! E
F64 b
