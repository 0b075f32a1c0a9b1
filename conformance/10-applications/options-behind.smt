spec 10.1   Options behind the tasks of an executor are reported once.

-- rocket.app --
[flight]
every 10 ms:
    task a
    log
log "f.log" 4 KB             #! E1053 [options]
state_vector "rocket.sv"
time time 1 ms
-- rocket.sv --
[A]
U64  time
