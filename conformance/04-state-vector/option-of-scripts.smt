spec 4.2  An option of scripts is none of a state vector.

-- app.sv --
[options]
delta_t 10   #! E0372
[R]
F64 a
