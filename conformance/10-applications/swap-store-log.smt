spec 10.28   It is neither a source nor the log.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
swap 4 KB
log "a.bin" 4 KB
keep "mission.sm"          #! E1052 a machine's
swap_store "./a.bin"       #! E1052 the log's
[flight]
every 10 ms:
    machine mission "mission.sm" @bytecode @swap
    log
    keep
-- rocket.sv --
[A]
U64  time
U32  missionState
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
[Boost] @swap
