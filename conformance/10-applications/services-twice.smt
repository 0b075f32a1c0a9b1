spec 10.13   inputs, outputs, log and keep stand once in an application.

-- rocket.app --
[options]
state_vector "rocket.sv"
log "f" 4 KB
keep "k"
[flight]
every 10 ms:
    log
    keep
every 20 ms:
    log                       #! E1039 'log'
[slow]
every 1 s:
    keep                      #! E1039 'keep'
-- rocket.sv --
[options]
lock
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
