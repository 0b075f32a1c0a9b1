spec 9.9  The safe value of a digital output is true or false, that of an analog output a number.

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
o 0 heater @safe false        #! E1184 not false
[digital]
o 0 open @safe 1              #! E1183 write true
o 1 vent @safe -0             #! E1183 write false
o 2 open @safe 5              #! E1183 not 5
o 3 open @safe                #! E1180 expected a number after '@safe'
