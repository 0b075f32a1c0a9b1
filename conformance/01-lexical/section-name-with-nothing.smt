spec 1.23  A section header with anything else in its brackets is an error.

-- app.sv --
[]   #! E0120
F64 x
[Other]
F64 y
