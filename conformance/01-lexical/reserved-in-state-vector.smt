spec 1.11  A reserved word cannot name an element of a state vector.

-- app.sv --
[R]
F64 a
F64 or   #! E0354
