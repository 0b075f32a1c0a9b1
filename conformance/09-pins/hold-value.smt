spec 9.11  Other numbers of steps are errors.

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
i 0 pressure @hold 256         #! E1185 not 256
i 1 flow @hold -1              #! E1185 not -1
i 2 count @hold 1.5            #! E1185 not 1.5
