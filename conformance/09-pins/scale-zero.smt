spec 9.8  A scale of 0 is an error, for inputs and outputs.

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
i 0 pressure @scale 0      #! E1182 '@scale' of 'pressure' is 0
o 1 heater @scale -0.0     #! E1182
o 2 flow @scale 1e-300
