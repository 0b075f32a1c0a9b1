spec 10.29   A parameter of a machine has the value of its binding from the start; without one, its default.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine main "channel.sm"
    machine drogue "channel.sm" { fire = fireDrogue  state = drogueState  go = apogee  burn = 0.05 s  gain = +0.5 }
-- flight.ss --
[all_states]
true:           @assert main.burn == 1000 and main.gain == 2 and drogue.burn == 50 and drogue.gain == 0.5
at 0:           go = true
at 0:           apogee = true
from 10 to 60:  @assert fire and fireDrogue
after 60:       @assert not fireDrogue
at 60:          @assert fire
at 1000:        @assert fire
at 1010:        @assert not fire
at 1010:        @stop
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
