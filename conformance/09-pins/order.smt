spec 9.2  A line begins with its direction: one message for one that ends with it.

-- app.sv --
[Sensors]
F64 pressure
F32 flow
F64 i
-- app.io --
[analog]
pressure 0 i       #! E1172 write i 0 pressure
flow 1 o @scale 2  #! E1172 write o 1 flow
i 2 i
