spec 9.3  A pin is a whole number from 0 to 65535, in any form of a number.

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
i 65535 flow
i 0x10 count
o 1e3 heater
