spec 11.9  What becomes of an element while no message comes.

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
receive a on 5001 { throttle @hold }                       #! E1213 'a' has no '@timeout'
receive b on 5002 @timeout 1 s { small @hold @safe 0 }     #! E1214 'small' has more than one
receive c on 5003 @timeout 1 s { ventCommand @safe 0 }     #! E1215 '0' is not a value of 'ventCommand', a bool
receive d on 5004 @timeout 1 s { other @default 70000 }    #! E1215 a U16
receive e on 5005 @timeout 1 s { bad @default true }       #! E1215
receive f on 5006 @timeout 1 s { age @safe }               #! E1020 expected a number, true or false
