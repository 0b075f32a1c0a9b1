spec 8.42   The ticks of an application are what guards by time are judged with.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine main "channel.sm"
    machine drogue "channel.sm" { fire = fireDrogue  state = drogueState  go = apogee  burn = 20 }
-- flight.ss --
[all_states]
at 15:    @assert true      #! E0757
every 15: @assert true      #! E0758
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
