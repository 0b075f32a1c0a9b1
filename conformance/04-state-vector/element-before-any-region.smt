spec 4.1  An element must be in a region.

-- app.sv --
F64 a   #! E0301
[R]
F64 b
