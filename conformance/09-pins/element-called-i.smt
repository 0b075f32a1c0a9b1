spec 9.2  An element may be called i or o.

-- app.sv --
[R]
F64 i
F64 o
-- app.io --
[analog]
i 0 i
o 1 o
i 2
o
