spec 4.3  A name stands once in the whole vector, whatever its region and type.

-- app.sv --
[R]
F64 a
[Q]
F64 b
U8 a   #! E0602
