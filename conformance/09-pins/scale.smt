spec 9.8  @scale and @offset follow analog inputs and outputs; their numbers can have a sign.

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
i 0 pressure @scale 250 @offset -125
i 1 flow @offset +0.5 @scale -1e-3
o 2 heater @scale 0.5
o 3 count @offset 0
