spec 9.1  Analog and digital pins have sections of their own, in any order.

-- app.sv --
[Sensors]
F64 pressure
F32 flow
U16 count
bool limit
[Valves]
bool open
bool vent
F32 heater
-- app.io --
[digital]
o 0 open
[analog]
i 0 pressure
