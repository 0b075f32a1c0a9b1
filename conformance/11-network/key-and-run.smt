spec 11.18  A key needs a run.

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
receive a on 5001 @key groundKey { throttle }              #! E1217 '@key' needs '@run'
receive b on 5002 @run bad { small }                       #! E1217 '@run' needs '@key'
receive c on 5003 @key groundKey @run other { ventCommand }   #! E1033 '@run' is a U32
