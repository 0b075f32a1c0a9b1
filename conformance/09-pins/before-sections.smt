spec 9.1  Text before the first section is an error.

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
i 0 pressure      #! E0301
[digital]
o 0 open
