spec 9.2  What is neither a pin nor an annotation is an error.

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
i 0 pressure, flow          #! E0330 expected the end of the line, found ','
i 1 flow 5                  #! E0330 found the number 5
i 2 count @scale 1,5        #! E0116 write 1.5
