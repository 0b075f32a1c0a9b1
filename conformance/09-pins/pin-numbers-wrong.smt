spec 9.3  No other number is a pin.

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
i 65536 pressure       #! E1181 65536 is not a pin: a pin is a whole number from 0 to 65535
i -1 flow              #! E1181 -1 is not a pin: a pin is a whole number from 0 to 65535
i 1.5 count            #! E1181 1.5 is not a pin: a pin is a whole number from 0 to 65535
