spec 11.1 11.3 11.4  Every form of a message.

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
send telemetry every 100 ms to ground { [Tank] }
send status every 1 s to udp 239.1.2.3:5001 @interface 10.0.0.7 @count sent other { tankPressure }
receive commands on 5002 @timeout 500 ms @age age @count refused bad { ventCommand @safe false throttle @hold }
receive small on 10.0.0.7:5003 { small }
