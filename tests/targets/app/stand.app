# Every part of the runtime that has no file or wire behind it: rates, machines as C and on the VM, modes, events, vitals, values at the
# start.  Its task `tell` writes down the whole state vector in each tick, which is to be the same on every processor.
[options]
state_vector "stand.sv"
time         time 1 ms
events       8

[start]
offset  = -300
armed   = true
gain    = 1 / 3
low     = -0.0
mode    = 1

[control] @ticks ticks
every 20 ms:
    task    sensors
    machine vent  "vent.sm"
    machine watch "watch.sm"
    task    valve @mode mode @safe
    task    tell
every 100 ms:
    task    slow
