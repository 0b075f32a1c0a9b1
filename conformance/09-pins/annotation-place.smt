spec 9.12  An annotation is allowed only where its clause says.

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
i 0 pressure @safe 5           #! E1179 '@safe' is not allowed after an analog input
i 1 flow @inverted             #! E1179 it belongs to a digital input or a digital output
o 2 heater @hold 3             #! E1179 '@hold' is not allowed after an analog output
[digital]
i 0 limit @scale 2             #! E1179 '@scale' is not allowed after a digital input
i 1 vent @safe true            #! E1179 it belongs to an analog output or a digital output
o 2 open @pull_up @offset 5    #! E1179 '@pull_up' #! E1179 '@offset'
