spec 9.12  An annotation belongs to the pin before it, on another line too.

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
i 0 pressure
    @scale 250
i 1 flow
@hold 3 i 2 count              #! W0301 belongs to 'flow' above
