spec 9.1  There are no other sections.

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
[analogue]         #! E1170 did you mean '[analog]'?
i 0 pressure
[options]          #! E1170 section [options] is not allowed among pins
lock
[digital]
o 0 open
