spec 4.4   Two regions of one name are an error.
-- app.sv --
[Sensors]
F64 pressure
[Effectors]
bool valveOpen
[Sensors]                     #! E0601 'Sensors' is declared here
F64 flow
