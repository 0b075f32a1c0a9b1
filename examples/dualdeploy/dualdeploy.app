# A recovery computer: one machine decides, and two igniters are one machine, twice.

[options]
state_vector "dualdeploy.sv"
time         time 1 ms
log          "dualdeploy.log" 64 KB

[recovery]
every 10 ms:
    task plant
    machine flight "flight.sm"
    machine drogue "channel.sm" { go = apogee  fire = drogueFire  state = drogueState }
    machine main   "channel.sm" { go = low     fire = mainFire    state = mainState }
every 100 ms:
    log
