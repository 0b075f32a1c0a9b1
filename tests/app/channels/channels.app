# Three igniters from one file.
[options]
state_vector "channels.sv"
time         time 1 ms

[start]
armed = true

[flight]
every 10 ms:
    task plant
    machine drogue "channel.sm" { fire = fireDrogue  go = apogee  state = drogueState }
    machine main   "channel.sm"
    task show
every 20 ms:
    machine spare  "channel.sm" { go = fireDrogue  fire = fireSpare
                                  S = spareState } @state Fire
