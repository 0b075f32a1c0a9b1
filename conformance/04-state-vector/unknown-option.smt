spec 4.2  Any other option is an error.

-- app.sv --
[options]
spinlock   #! E0371
[R]
F64 a
