spec 9.5  An analog bool and a digital number are errors.

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
i 0 limit        #! E1176 'limit' is bool
o 1 open         #! E1176
[digital]
i 0 count        #! E1175 'count' is U16: a digital pin needs a bool
o 1 heater       #! E1175 'heater' is F32
