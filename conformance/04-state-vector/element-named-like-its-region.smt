spec 4.3, 4.4  A region may be named like an element: the two are never confused.

-- app.sv --
[a]
F64 a
[b]
F64 c
