spec 4.4  A region appears once.

-- app.sv --
[R]
F64 a
[Q]
F64 b
[R]   #! E0601
F64 c
