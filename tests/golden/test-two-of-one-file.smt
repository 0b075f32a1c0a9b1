# Notes about why an assert failed name the machine, because both machines have the same source.
args test two.app flight.ss -w

-- two.app --
[options]
state_vector "two.sv"
time time 1 ms

[flight]
every 10 ms:
    machine main   "channel.sm"
    machine drogue "channel.sm" { fire = fireDrogue  state = drogueState  volts = drogueVolts }
-- two.sv --
[A]
U64  time
U32  state
U32  drogueState
F64  volts
F64  drogueVolts
bool fire
bool fireDrogue
-- channel.sm --
[state_vector]
U64  time  @alias G
U32  state @alias S
F64  volts @read_only
bool fire

[Wait] @safe
.step
    volts > 5: -> Fire

[Fire] @safe
.step
    fire = T < 20 ms
-- flight.ss --
[all_states]
at 0: drogueVolts = 6
at 20: volts = 6
at 40: @assert not fire and fireDrogue
at 60: @stop
-- exit --
1
-- stderr --
...
channel.sm:9:16: note: transition in step 3 (G = 20): main.Wait -> Fire
channel.sm:13:5: note: main: step 5 (G = 40): `fire = T < 20 ms` stored true: T = 10
channel.sm:13:5: note: drogue: step 5 (G = 40): `fire = T < 20 ms` stored false: T = 30
1 error
