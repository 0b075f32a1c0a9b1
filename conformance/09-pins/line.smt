spec 9.2  A line is a direction, a pin and an element.

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
[analog]
i 0 pressure
o 1 heater
[digital]
i 0 limit
o 1 open
