spec 11.12, 11.13  Connections that cannot be distinguished, or return.

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
send a every 10 ms to tcp 10.0.0.2:1 { throttle }
send b every 10 ms to tcp 10.0.0.2:1 { tankPressure }      #! E1211 'a' and 'b' both connect to 10.0.0.2:1
receive c from tcp 10.0.0.2:1 { small }                    #! E1211
receive d on tcp 5001 { bad }
send e every 10 ms on tcp 10.0.0.7:5001 { throttle }       #! E1211 both listen on 10.0.0.7:5001
send f every 10 ms to tcp 127.0.0.1:5002 { throttle }      #! E1212 where this computer itself receives 'g'
receive g on tcp 5002 { age }
receive h from tcp 10.0.0.7:5003 { other }
receive j from tcp 127.0.0.1:5004 { valveOpen }
send k every 10 ms on tcp 5004 { throttle }                #! E1212
send i every 10 ms on tcp 10.0.0.7:5003 { throttle }       #! E1212
