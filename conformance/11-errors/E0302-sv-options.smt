spec 4.2   [options] of a state vector appears once.

-- app.sv --
[options]
lock
[A]
F64 a
[options]      #! E0302 [options]
