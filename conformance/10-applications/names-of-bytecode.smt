spec 10.17   A machine that is bytecode makes no file of its own, and may be called like the state vector.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine mission "rocket.sm" @bytecode
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
F64  target
-- rocket.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
