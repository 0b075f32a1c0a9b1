spec 9.2, 9.3  A pin follows the direction.

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
i pressure         #! E1173 found 'pressure'
o A1 heater        #! E1173 found 'A1'
i                  #! E1173 found the end of the file
