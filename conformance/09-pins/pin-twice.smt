spec 9.6  A pin appears once in a section, with any direction and in any form.

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
o 0 heater         #! E1177 duplicate analog pin 0
i 16 flow
i 0x10 count       #! E1177 duplicate analog pin 0x10
[digital]
o 0 open
o 16 vent
o 16 open          #! E1177 duplicate digital pin 16
