spec 9.12  There are no other annotations.

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
i 0 pressure @skale 250        #! E0360 did you mean '@scale'?
i 1 flow @range 0 5            #! E0360 unknown annotation '@range'
[digital]
i 0 limit @pullup              #! E0360 did you mean '@pull_up'?
