spec 4.5  A region holds at least one element.

-- app.sv --
[R]
F64 a
[Q]   #! E
[P]
F64 b
