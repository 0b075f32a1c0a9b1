spec 4.5   An empty region is an error.
-- app.sv --
[Sensors]                     #! E0603 region 'Sensors' is empty
[Effectors]
bool valveOpen
