spec 4.1  Elements have no initial value: they belong to the outside world.

-- app.sv --
[R]
F64 a = 5   #! E0356
