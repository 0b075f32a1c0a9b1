spec 10.25   A path of a socket has up to 107 characters.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 4 KB
swap_at "ssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssss"        #! E1034 1 to 107 characters
[flight]
every 10 ms:
    machine mission "mission.sm" @bytecode @swap
-- rocket.sv --
[A]
U64  time
U32  missionState
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
[Boost] @swap
