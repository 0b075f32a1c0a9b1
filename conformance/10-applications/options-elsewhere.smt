spec 10.1   Options without their section are reported once, and the following sections are read.

-- rocket.app --
[flight]                     #! E1048 begins as [options] does
state_vector "rocket.sv"
time time 1 ms
watchdog 500 ms
log "f.log" 4 KB
keep "kept"
every 10 ms:
    task a
    log
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
F64  target
