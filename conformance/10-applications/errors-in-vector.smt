spec 10.1, 10.15   Where the state vector is wrong, no name of it is called unknown.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight] @late nosuch
every 10 ms:
    machine mission "mission.sm" @mode nosuch
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
U8   mode     #! E0602
U8   otherMode
U32  late
U32  busy
F64  target
I16  small
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
