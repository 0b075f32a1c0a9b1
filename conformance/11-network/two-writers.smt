spec 11.11  An element that the network writes has no other writer.

-- app.sv --
[Tank]
F64  tankPressure
bool valveOpen
[Commands]
bool ventCommand
F32  throttle
I16  small
U32  age
U32  bad
U16  other
-- app.net --
receive a on 5001 { throttle small }
receive b on 5002 @age small { throttle }                  #! E1210 'throttle' has two writers #! E1210 'small' has two writers
