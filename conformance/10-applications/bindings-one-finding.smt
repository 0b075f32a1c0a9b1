spec 10.31   A finding names the machines in which it is true, unless these are all machines of the file.
warn flight

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 5 ms:
    machine main   "channel.sm"
every 10 ms:
    machine drogue "channel.sm" { fire = fireDrogue  state = drogueState }
    machine third  "channel.sm" { fire = fireThird  state = thirdState }
-- rocket.sv --
[A]
U64  time
U32  state
U32  drogueState
U32  thirdState
bool fire
bool fireDrogue
bool fireThird
-- channel.sm --
[state_vector]
U64  time  @alias G
U32  state @alias S
bool fire

[Wait] @safe
.step
    fire = false
    T == 15: -> Fire         #! W0408 machine 'drogue' and 'third'
    T > 1_000_000: -> Fire

[Fire]
.step
    fire = true
    T == 20: -> Wait
