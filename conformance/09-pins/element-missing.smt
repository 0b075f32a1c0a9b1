spec 9.2  An element follows the pin.

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
i 0                #! E1174 expected the element of pin 0, found the end of the line
i 1 @scale 5       #! E1174 expected the element of pin 1, found '@scale'
o 3 heater
