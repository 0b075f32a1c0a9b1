spec 9.2  Line ends are blanks, and a comment ends a line.

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
[analog] i 0
pressure      # of the tank
@scale
250 o 1 heater i
2 # a word on each line
flow
@hold 3
