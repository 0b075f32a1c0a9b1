spec 8.37   In the script of an application, the name of a machine precedes that of its parameter.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine main "channel.sm"
    machine drogue "channel.sm" { fire = fireDrogue  state = drogueState  go = apogee  burn = 50 }
-- flight.ss --
[options]
set main.burn 30 ms
set drogue.burn 80

[all_states]
true:           @assert main.burn == 30 and drogue.burn == 80
at 0:           go = true
at 0:           apogee = true
at 40:          @assert not fire and fireDrogue
at 90:          @assert not fireDrogue
at 90:          @stop
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
