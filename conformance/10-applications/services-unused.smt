spec 10.13   An option that no task uses is a warning.

-- rocket.app --
[options]
state_vector "rocket.sv"
log "f" 4 KB                  #! W1040 'log' is a task of no executor
keep "k"                      #! W1040
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
