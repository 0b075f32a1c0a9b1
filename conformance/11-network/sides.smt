spec 11.4  Which word comes before the address.

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
send a every 10 ms on 5001 { throttle }     #! E1203 write 'to' and an address
send b every 10 ms from 10.0.0.2:1 { throttle }  #! E1203 'to' and an address
receive c from 10.0.0.2:5002 { small }      #! E1203 write 'on' and a port
receive d to 10.0.0.2:5003 { bad }          #! E1203
receive e 5003 { other }                    #! E1020 expected 'on' or 'from'
