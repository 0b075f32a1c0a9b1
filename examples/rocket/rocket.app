# The application: which tasks run when. Five tasks around one state vector, and the plant that they fly in.

[options]
state_vector "rocket.sv"
time         time 1 ms
log          "flight.log" 64 KB

[start]
# Before the mission has said anything, nothing opens and nothing is fired.
engineMode    = 1
parachuteMode = 1
propellant    = 2
noise         = 2026

[flight] @priority 50 @overruns overruns @late late
every 10 ms:
    task    plant
    task    sensor
    task    navigation
    machine mission "mission.sm"
    task    engine     @mode engineMode    @safe
    task    parachute  @mode parachuteMode @safe
every 100 ms:
    log
