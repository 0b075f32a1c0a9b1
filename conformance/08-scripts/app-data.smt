spec 8.54, 8.66   Recorded data is written to elements of an application, and compared with them.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine main "channel.sm"
    machine drogue "channel.sm" { fire = fireDrogue  state = drogueState  go = apogee  burn = 20 }
-- d.csv --
t,GO,APOGEE,FIRE
0,0,0,0
10,1,0,0
20,1,1,1
-- flight.ss --
[data]
file "d.csv"
time "t" ms
go = "GO"
drogue.go = "APOGEE"
@compare main.fire "FIRE"
[all_states]
at 10: @assert go and not apogee
at 30: @assert fire and fireDrogue
at 30: @stop
-- rocket.sv --
[A]
U64  time
U32  state
U32  drogueState
bool go
bool apogee
bool fire
bool fireDrogue
-- channel.sm --
[options]
time_unit ms

[state_vector]
U64  time  @alias G
U32  state @alias S
bool go    @read_only
bool fire

[local]
U32 burn = 1000 @parameter @range 0 5000
F32 gain = 2 @parameter @range -1 10

[Idle] @safe
.step
    go: -> Fire

[Fire]
.entry
    fire = true
.step
    T >= burn and gain > 0: -> Done
.exit
    fire = false

[Done] @safe
