spec 9.1  A section appears once.

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
[digital]          #! E0302 duplicate section [digital]
o 1 vent
