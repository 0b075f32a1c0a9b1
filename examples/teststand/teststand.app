# The application of the test stand: two machines between pins. No C is written for it.

[options]
state_vector "teststand.sv"
io           "teststand.io"
time         time 1 ms
watchdog     200 ms
log          "teststand.log" 64 KB

[control] @priority 80 @overruns overruns @late late
every 10 ms:
    inputs
    machine monitor "monitor.sm"
    machine stand   "stand.sm"
    outputs
every 100 ms:
    log
