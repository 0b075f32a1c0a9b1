spec 11.11 11.19  The messages of an application: other writers, periods, tasks.

-- rocket.app --
[options]
state_vector "rocket.sv"
io "rocket.io"
net "rocket.net"
time time 1 ms
[flight] @late late
every 10 ms:
    receive
    inputs
    machine mission "mission.sm"
    send
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
F64  target
U32  late
U32  free
-- rocket.io --
[analog]
i 0 altitude
-- rocket.net --
receive a on 5001 { altitude }             #! E1210 'altitude' has two writers: the message 'a' and an input
receive b on 5002 { target }               #! E1210 and machine 'mission'
receive c on 5003 { late }                 #! E1210
receive d on 5004 { time }                 #! E1210 and the time
receive e on 5005 { missionState }         #! E1210
send f every 25 ms to 10.0.0.2:1 { free }  #! E1219 every 25 ms, which is not a multiple of 10 ms
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
F64  target
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
.step
    target = 1
