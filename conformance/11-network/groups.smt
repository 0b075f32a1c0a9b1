spec 11.5  Multicast groups.

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
receive b on 239.1.2.4:5001 @interface 10.0.0.7:5 { small }   #! E1201 is not an address:
receive c on 239.1.2.5:5001 @interface 10.0.0.7 { bad }
