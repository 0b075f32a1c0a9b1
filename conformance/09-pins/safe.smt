spec 9.9  @safe follows outputs: a number, or true or false.

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
o 0 heater @safe -2.5
o 1 count @safe 70000
[digital]
o 0 open @safe false
o 1 vent @safe true
