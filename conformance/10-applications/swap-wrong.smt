spec 10.21, 10.22, 10.23, 10.24   Only a machine on the VM can be swapped, and the options have limits.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 255 B                #! E1034 256 B to 1048576 KB
swap_trial 0              #! E1034 1 to 1000000000 steps
swap_limit 0.5            #! E1034 1 to 1000000000 instructions
armed mode                #! E1033 a bool
[flight]
every 10 ms:
    machine mission "mission.sm" @swap      #! E1054
    task engine @swap                       #! E1024
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
