spec 9.4  An element is one of the state vector; an unknown name is reported once.

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
i 0 presure       #! E0205 did you mean 'pressure'?
o 1 presure
i 2 Pressure      #! E0205 did you mean 'pressure'?
i 3 thrust        #! E0205 the state vector has no element 'thrust'
[digital]
o 0 Sensors.limit #! E0335
