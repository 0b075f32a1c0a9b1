spec 4.5  The last region too.

-- app.sv --
[R]
F64 a
[Q]   #! E0603
# nothing
