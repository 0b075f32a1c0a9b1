spec 10.3   It advances between two steps of a machine.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 500 us:
    machine mission "mission.sm"     #! E1050 'mission' steps every 500 us, but 'time' counts in units of 1 ms
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
