spec 4.2   Options of a script have no place in a state vector.

-- app.sv --
[options]
delta_t 10      #! E0372 'delta_t'
[A]
F64 a
