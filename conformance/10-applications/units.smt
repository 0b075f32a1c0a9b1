spec 10.3, 10.4, 10.6, 10.11   An unknown unit is an error that names those that there are.

-- rocket.app --
[options]
state_vector "rocket.sv"
watchdog 500 msec            #! E1027 ms
time time 1 tick             #! E1027 ns, us, ms or s
log "f" 4 kB                 #! E1027 KB
[flight]
every 10 Hz:                 #! E1027 ns, us, ms or s
    task a
at 10 hz:                    #! E1027 Hz
    task b
every 20ms:                  #! E1028 20 ms
    task c
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
