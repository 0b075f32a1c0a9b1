spec 4.2  [options] may be empty, and stand after the regions.

-- app.sv --
[R]
F64 a
[options]
