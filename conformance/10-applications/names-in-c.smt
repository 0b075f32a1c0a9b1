spec 10.17   Names in C stand for one thing.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    task navigation @init
    task mission @safe                #! E1044 mission_step
    task rocket @safe                 #! E1044 rocket_step
    machine nav "mission.sm"
    task navigation2
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
U8 step
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
