spec 9.8  @scale and @offset are followed by one number.

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
i 0 pressure @scale = 250       #! E1180 expected a number after '@scale', found '='
i 1 flow @offset                #! E1180 found the end of the line
o 2 heater @scale true          #! E1180 found 'true'
i 3 count @scale 2 * 3          #! E0330 found '*'
