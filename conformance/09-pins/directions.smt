spec 9.2  There are no other directions.

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
F64 limits
-- app.io --
[analog]
in 0 pressure      #! E1172 did you mean 'i'?
output 1 heater    #! E1172 did you mean 'o'?
x 2 flow           #! E1172 found 'x'
3 count            #! E1172 found the number 3
i 4 limits
