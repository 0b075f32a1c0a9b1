spec 11.2  Addresses and ports.

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
endpoint ground 10.0.0.2:5000
endpoint ground 10.0.0.3:5000               #! E1039 duplicate endpoint 'ground'
endpoint far 10.0.0.256:5000                #! E1201 '10.0.0.256:5000' is not an address
endpoint odd 10.0.0.2.7:5000                #! E1201
endpoint bare 10.0.0.2                      #! E1201
send a every 10 ms to 10.0.0.2 { throttle } #! E1201
send b every 10 ms to grund { throttle }    #! E1202 there is no endpoint 'grund'
send c every 10 ms to 0.0.0.0:5000 { small } #! E1201
receive d on 70000 { bad }                  #! E1201 '70000'
receive e on 0 { other }                    #! E1201
