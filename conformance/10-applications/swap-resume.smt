spec 10.15   S has the number of a state of the machine that ran last.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 4 KB
swap_store "rocket.images"
keep "rocket.state"
[flight]
every 10 ms:
    machine mission "mission.sm" @bytecode @swap @resume      #! E1059
    keep
-- rocket.sv --
[A]
U64  time
U32  missionState
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
[Boost] @swap
