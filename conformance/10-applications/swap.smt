spec 10.21, 10.22, 10.23, 10.24   Options of swaps, and a machine that can be swapped.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 1000 B
swap_trial 50
swap_limit 200
armed armed
[flight]
every 10 ms:
    machine mission "mission.sm" @bytecode @swap
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
