spec 10.1   Nor do they stand among values; elements may be called like them.

-- rocket.app --
[start]
time = 1
state_vector "rocket.sv"     #! E1053 [options]
watchdog 500 ms
[flight]
every 10 ms:
    task a
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
F64  target
