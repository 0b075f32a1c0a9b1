spec 10.25, 10.27   A serial line has a speed.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 4 KB
swap_at "/dev/ttyS1"
swap_speed 100               #! E1034 1200 to 4000000 bits per second
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
