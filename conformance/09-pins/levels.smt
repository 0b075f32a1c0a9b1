spec 9.10  @inverted follows digital pins, @pull_up and @pull_down follow digital inputs.

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
i 0 limit @pull_up @inverted
o 1 open @inverted
i 2 vent @inverted @pull_down
