spec 10.29   An element is not bound to a value.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine drogue "channel.sm" { fire = true }     #! E1225 fire
-- rocket.sv --
[A]
U64  time
U32  state
U32  drogueState
bool armed
bool go
bool apogee
bool fire
bool fireDrogue
F64  volts
-- channel.sm --
[state_vector]
U64  time  @alias G
U32  state @alias S
bool armed @read_only
bool go    @read_only
bool fire

[local]
U64 burn = 1000 @read_only

[Idle] @safe
.step
    armed and go: -> Fire

[Fire]
.entry
    fire = true
.step
    T >= burn: -> Done
.exit
    fire = false

[Done] @safe
