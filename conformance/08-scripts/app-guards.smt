spec 8.39, 8.44, 8.46, 8.77   Guards by time, states as values and nested conditionals in the script of an application.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine main "channel.sm"
every 50 ms:
    machine drogue "channel.sm" { fire = fireDrogue  state = drogueState  go = apogee  burn = 100 }
-- flight.ss --
[options]
seed 7

[local]
F64 noisy = 0
U32 fifties = 0

[define]
disturbance = noise(2)

[all_states]
every 50: fifties = fifties + 1
true: noisy = disturbance
true: @assert noisy == disturbance
at 10:            apogee = true
from 80 to 120 {
    state drogue.Fire: @assert G >= 100 and fireDrogue
    else:              @assert G < 100 and not fireDrogue
}
at 150:           @assert state drogue.Fire and fifties == 4
at 250:           @assert state drogue.Done and state main.Idle
at 250:           @stop

[drogue.Fire]
every 50 {
    drogue.T == 0:       @assert G == 100
    else if drogue.T < 100: @assert G == 150
    else:                @assert G == 200
}
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
