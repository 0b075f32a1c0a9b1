spec 11.3  Names are unique; a period is from 1 us to 1 h.

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
send a every 10 ms to 10.0.0.2:1 { throttle }
receive a on 5001 { small }                 #! E1039 duplicate message 'a'
send b every 2 h to 10.0.0.2:2 { throttle } #! E1027
send c every 7200 s to 10.0.0.2:3 { throttle } #! E1034 a period must be 1 us to 1 h
send d to 10.0.0.2:4 { throttle }           #! E1020 expected 'every'
receive every on 5002 { bad }
