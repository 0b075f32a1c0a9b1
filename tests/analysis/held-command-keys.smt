# Two keys that are still turned after the abort: the message names both, no button that a rising edge reads, and no lamp.
warn no-all held-command

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time    @alias G
U32  state   @alias S
bool key     @read_only @command
bool arm     @read_only @command
bool lamps   @read_only @command
F32  chamber @read_only @range 0.5 60
bool igniter
bool valve
bool lamp

[all_states] @except Idle Abort
.step
    not key: -> Abort
    not arm: -> Abort
    chamber > 40: -> Abort

[Idle] @safe
.step
    lamp = key
    key and arm and T > 1 s: -> Ignite

[Ignite]
.entry
    igniter = true
.step
    T > 1 s: -> Burn
.exit
    igniter = false

[Burn]
.entry
    valve = true
.step
    T > 3 s: -> Abort
    rising(lamps): -> Abort
.exit
    valve = false

[Abort] @abort
.entry
    igniter = false
    valve = false
    lamp = false
.step
    T >= 5 s and chamber < 2: -> Idle         #! W0919 after 'Abort' the machine switches 'igniter' on again in 'Ignite', with 'key' and 'arm' still on
