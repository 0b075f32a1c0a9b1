spec 11.1  A line begins with endpoint, send or receive.

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
recieve commands on 5001 { throttle }       #! E1200 found 'recieve'
receive other on 5002 { small }
[network]                                   #! E1200
