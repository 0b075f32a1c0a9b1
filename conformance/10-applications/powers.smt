spec 10.5, 10.6   Where a power of two is wanted, the nearest are named.

-- rocket.app --
[options]
state_vector "rocket.sv"
events 100                   #! E1034 64 or 128 would be
log "f" 60 KB                #! E1034 32 KB or 64 KB would be
[flight]
every 10 ms:
    log
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
F64  target
