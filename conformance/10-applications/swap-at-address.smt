spec 10.25   A port needs a number, and the address four.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 4 KB
swap_at "10.0.0.5:70000"     #! E1055 '10.0.0.5:70000' is not an address with a port
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
