spec 9.6  Analog and digital pins are numbered apart.

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
[digital]
o 0 open
