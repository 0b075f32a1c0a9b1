spec 8.72, 8.39   Where ticks are shorter than a unit of G, several ticks have the same G.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 500 us:
    task sample
every 1 ms:
    machine main "channel.sm"
-- flight.ss --
[local]
U32 n = 0
[all_states]
every 2: n = n + 1
at 5:    @assert n == 6
at 5:    @stop
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
