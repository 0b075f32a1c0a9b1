spec 4.3   A name is declared once in the whole file.
-- app.sv --
[Sensors]
F64 pressure
U8  pressure                  #! E0602
[Effectors]
F64 pressure                  #! E0602 'pressure' is declared here
