spec 9.11  @hold follows inputs, from 0 to 255 steps.

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
i 0 pressure @hold 0
i 1 flow @hold 255
[digital]
i 0 limit @hold 0x10
