spec 11.21  Either side of a TCP connection can listen.

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
send a every 10 ms to tcp ground @count unconnected bad { [Tank] }
send b every 10 ms on tcp 5001 @peers 16 { tankPressure }
receive c on tcp 10.0.0.7:5002 @peers 2 @timeout 500 ms { ventCommand @safe false }
receive d from tcp 10.0.0.3:5003 @count connected age { throttle }
receive e on 5001 { small }                 # a port of UDP is another one than that of TCP
send f every 10 ms to 10.0.0.2:5000 { valveOpen }
