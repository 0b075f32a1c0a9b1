spec 10.26   A key and a speed without a place.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 4 KB
swap_key "stand.key"         #! W1040 without 'swap_at' the application cannot be reached
swap_speed 9600              #! W1040 without 'swap_at' the application cannot be reached
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
