# Every part of an application, small: two rates, a machine, modes, values at the start, what the executor tells, a log.
[options]
state_vector "probe.sv"
time         time 1 ms
watchdog     1 s
events       16
log          "probe.log" 4 KB

[start]
pressure = 2.5
mode     = 1
offset   = -300
armed    = true
gain     = 1 / 3

[flight] @late late @ticks ticks
every 10 ms:
    task first @init
    machine rise "rise.sm"
    task last @mode mode @safe
at 20 Hz:
    task slow
    log
