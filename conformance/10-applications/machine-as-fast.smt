spec 10.3   It advances between two steps of a machine, as often as they are.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 1 ms:
    machine mission "mission.sm"
every 3 ms:
    task slow
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
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
