spec 10.21, 10.24   Options of swaps without a machine that can be swapped.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 1 KB                 #! W1040 no machine has '@swap'
armed armed               #! W1040
[flight]
every 10 ms:
    machine mission "mission.sm" @bytecode
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
[Boost] @swap
