spec 9.1  The other may be missing too, and a section may be empty.

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
