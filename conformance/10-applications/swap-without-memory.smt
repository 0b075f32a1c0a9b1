spec 10.21   A machine that can be swapped needs memory, and a state in which it may be replaced.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine mission "mission.sm" @bytecode @swap      #! E1030 swap 16 KB #! W1046 'mission' can never be swapped
-- rocket.sv --
[A]
U64  time
U32  missionState
U8   mode
bool armed
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
[Boost]
