spec 10.3, 10.4, 10.5, 10.6, 10.10   Numbers outside their ranges are errors.

-- rocket.app --
[options]
state_vector "rocket.sv"
time     time 0 ms           #! E1034 1 ns to 1 h
watchdog 2 h                 #! E1027
events   100                 #! E1034 power of two from 8
log      "f" 3 KB            #! E1034 power of two
[flight] @priority 100       #! E1034 1 to 99
    @overrun catch_up 0      #! E1034 1000000 ticks
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
