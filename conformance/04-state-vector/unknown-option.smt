spec 4.2  Any other option is an error.

-- app.sv --
[options]
spinlock   #! E
[R]
F64 a
