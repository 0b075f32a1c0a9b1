spec 9.7  At most one input reads into an element.

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
i 1 pressure       #! E1178 'pressure' is read from two pins
[digital]
i 0 limit
i 1 limit          #! E1178
