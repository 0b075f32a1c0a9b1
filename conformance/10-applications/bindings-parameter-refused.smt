spec 10.29   The value of a parameter is a number or a time, which it does not refuse.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine main "channel.sm"
    machine drogue "channel.sm" { fire = fireDrogue  state = drogueState  burn = 5001  gain = time }     #! E0424 5001  #! E0424 'gain' to time: the value is not a number
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
