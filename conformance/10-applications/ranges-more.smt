spec 10.4, 10.5, 10.6   Fractions and numbers beyond every range are errors as well.

-- rocket.app --
[options]
state_vector "rocket.sv"
watchdog 0.5 us              #! E1034 1 ms to 1 h
events   8.5                 #! E1034 32768
log      "f" 1e300 KB        #! E1034 1048576 KB
[flight] @priority 1234567890123456789012345     #! E1034 1 to 99
every 10 ms:
    task navigation
    log
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
U8   otherMode
U32  late
U32  busy
F64  target
I16  small
