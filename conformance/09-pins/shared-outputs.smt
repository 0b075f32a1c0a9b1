spec 9.7  Outputs may share an element, and an input may be an output as well.

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
o 1 pressure
o 2 pressure
[digital]
o 0 open
o 1 open
i 2 open
