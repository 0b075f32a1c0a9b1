spec 11.12  Channels that cannot be distinguished.

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
receive a on 5001 { throttle }
receive b on 10.0.0.7:5001 { small }                       #! E1211 'a' and 'b' both receive on 10.0.0.7:5001
receive c on 10.0.0.7:5002 { bad }
receive d on 10.0.0.8:5002 { age }
send e every 10 ms to 10.0.0.2:1 { small }
send f every 10 ms to 10.0.0.2:1 { small bad }             #! E1211 both send to
