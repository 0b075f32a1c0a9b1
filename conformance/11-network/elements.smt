spec 11.6  Elements and regions.

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
send a every 10 ms to 10.0.0.2:1 { [Tank] tankPressure }   #! E1207 'tankPressure' is twice
send b every 10 ms to 10.0.0.2:2 { [Tanks] }               #! E1206 no region [Tanks]
send c every 10 ms to 10.0.0.2:3 { tankPresure }           #! E0204 did you mean
send d every 10 ms to 10.0.0.2:4 { }                       #! E1208
send e every 10 ms to 10.0.0.2:5 { throttle, small }       #! E1205
send f every 10 ms to 10.0.0.2:6 { throttle @safe 0 }      #! E1024 '@safe' is not allowed after an element that is sent
