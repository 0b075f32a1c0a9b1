spec 9.10  A pin has one resistor at most.

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
[digital]
i 0 limit @pull_up @pull_down                #! E1186 'limit' has both
i 1 open @pull_down @inverted @pull_up       #! E1186
