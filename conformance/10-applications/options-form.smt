spec 10.1   An option that is not complete is an error that shows a complete one.

-- rocket.app --
[options]
state_vector rocket.sv     #! E1020 state_vector "rocket.sv"
events many                  #! E1020 events 64
log "flight.log"             #! E1020 64 KB
time 1 ms                    #! E1020 time flightTime 1 ms
keep                         #! E1020 keep "rocket.state"
watchdog 500                 #! E1020 a unit: ns, us, ms or s
[flight]
every 10 ms:
    task navigation
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
