spec 10.6   The memory of the log has room for at least two records of the state vector.

-- rocket.app --
[options]
state_vector "rocket.sv"
log "f" 256 B                 #! E1034 at least 308 B
[flight]
every 10 ms:
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
