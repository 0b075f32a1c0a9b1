spec 11.13  A message does not return to its sender.

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
send a every 10 ms to 239.1.2.3:5000 { throttle }          #! E1212 where this computer itself receives 'b'
receive b on 239.1.2.3:5000 { small }
send c every 10 ms to 127.0.0.1:5001 { throttle }          #! E1212
receive d on 5001 { bad }
