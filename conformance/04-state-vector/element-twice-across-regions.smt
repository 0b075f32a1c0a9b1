spec 4.3  A name appears once in the whole vector, in any region and of any type.

-- app.sv --
[R]
F64 a
[Q]
F64 b
U8 a   #! E0602
