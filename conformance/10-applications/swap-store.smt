spec 10.26, 10.28   The stored images have a file of their own.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 4 KB
swap_at "stand.sock"
swap_key "stand.key"
swap_store "./stand.key"   #! E1052 that of 'swap_key'
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
