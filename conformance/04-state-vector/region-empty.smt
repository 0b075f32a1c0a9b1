spec 4.5  A region has at least one element.

-- app.sv --
[R]
F64 a
[Q]   #! E0603
[P]
F64 b
