spec 10.18   An element that the runtime writes has no other writer.

-- rocket.app --
[options]
state_vector "rocket.sv"
io "rocket.io"
time time 1 ms
[flight] @late late @busy busy        #! W1041 machine 'mission' #! W1041 an input
every 10 ms:
    inputs
    outputs
    machine mission "mission.sm"
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
U8   otherMode
U32  late
U32  busy
F64  target
I16  small
-- rocket.io --
[analog]
i 0 busy
o 1 target
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
U32  late
U32  busy @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
.step
    busy > 7: late = 1
