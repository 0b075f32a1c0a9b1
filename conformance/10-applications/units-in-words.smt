spec 10.3, 10.4   Units in other spellings, and what they are here.

-- app.app --
[options]
state_vector "app.sv"
log "f" 4 b               #! E1027 B
log "f" 4 bytes           #! E1027 B
log "f" 4 Bytes           #! E1027 B
log "f" 4 kB              #! E1027 KB
log "f" 4 kb              #! E1027 KB
log "f" 4 Kb              #! E1027 KB
log "f" 4 K               #! E1027 KB
log "f" 4 k               #! E1027 KB
log "f" 4 KiB             #! E1027 KB
[flight]
every 10 sec:             #! E1027 s
    task t0
every 10 secs:            #! E1027 s
    task t1
every 10 second:          #! E1027 s
    task t2
every 10 seconds:         #! E1027 s
    task t3
every 10 S:               #! E1027 s
    task t4
every 10 msec:            #! E1027 ms
    task t5
every 10 MS:              #! E1027 ms
    task t6
every 10 milliseconds:    #! E1027 ms
    task t7
every 10 usec:            #! E1027 us
    task t8
every 10 US:              #! E1027 us
    task t9
every 10 microseconds:    #! E1027 us
    task t10
every 10 nsec:            #! E1027 ns
    task t11
at 10 hz:                 #! E1027 Hz
    task t12
at 10 HZ:                 #! E1027 Hz
    task t13
at 10 KHz:                #! E1027 kHz
    task t14
at 10 khz:                #! E1027 kHz
    task t15
-- app.sv --
[A]
U64 time
