spec 9.12  An annotation appears once after a line.

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
i 0 pressure @scale 2 @hold 1 @scale 3       #! E0361 duplicate '@scale' on 'pressure'
[digital]
i 0 limit @inverted @inverted                #! E0361
