spec 10.25, 10.26   Other computers reach the application only with a key.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 4 KB
swap_at "10.0.0.5:4711"      #! E1056 other computers can reach '10.0.0.5:4711'
swap_speed 9600              #! W1040 'swap_at' is not a serial line
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
