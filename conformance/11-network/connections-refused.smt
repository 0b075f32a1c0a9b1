spec 11.21, 11.17  What a TCP connection cannot have.

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
send a every 10 ms from tcp 10.0.0.2:1 { throttle }        #! E1203 write 'to tcp' and an address, or 'on tcp' and a port
receive b to tcp 10.0.0.2:2 { small }                      #! E1203 'on tcp' and a port, or 'from tcp' and an address
send c every 10 ms to tcp 239.1.2.3:5000 { throttle }      #! E1204 'c' cannot combine TCP with a multicast group
receive d on tcp 239.1.2.3:5010 { ventCommand }            #! E1204
send e every 10 ms on tcp 5001 @interface 10.0.0.7 { throttle }          #! E1204 '@interface', which is for multicast groups
send f every 10 ms to tcp 10.0.0.2:3 @peers 2 { throttle }               #! E1220 it does not listen
receive g on 5003 @peers 2 { other }                       #! E1220
send h every 10 ms on tcp 5004 @peers 0 { throttle }       #! E1034 the number of peers must be 1 to 16
send i every 10 ms on tcp 5005 @peers 17 { throttle }      #! E1034
send j every 10 ms to tcp 5006 { throttle }                #! E1201
send k every 10 ms to 10.0.0.2:4 @count full bad { throttle }            #! E1216 'full' is not counted
receive l on tcp 5007 @count long bad { tankPressure }     #! E1216 'long' is not counted
send m every 10 ms on tcp 5008 @count accepted bad { throttle }          #! E1216
send n every 10 ms to tcp 0.0.0.0:5009 { throttle }        #! E1201
