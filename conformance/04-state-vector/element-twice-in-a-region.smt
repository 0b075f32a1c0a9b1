spec 4.3  A name appears once in a region.

-- app.sv --
[R]
F64 a
F64 b
F64 a   #! E0602
