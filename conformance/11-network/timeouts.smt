spec 11.8  A timeout is from 1 ms to 1 h.

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
receive a on 5001 @timeout 10 us { throttle }              #! E1034 the timeout must be 1 ms to 1 h
receive b on 5002 @timeout 1 ms @timeout 2 ms { small }    #! E0361
send c every 10 ms to 10.0.0.2:1 @timeout 1 s { throttle } #! E1024 '@timeout' is not allowed after a message that is sent
