# A button that starts and, pressed again, stops: no finding, because nothing stops when it is released, so it is not held through the abort.
warn no-all held-command

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time    @alias G
U32  state   @alias S
bool key     @read_only @command
F32  chamber @read_only @range 0.5 60
bool igniter
bool valve

[all_states] @except Idle Abort
.step

    chamber > 40: -> Abort

[Idle] @safe
.step
    key: -> Ignite

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
    rising(key): -> Idle
    T > 3 s: -> Abort
.exit
    valve = false

[Abort] @abort
.entry
    igniter = false
    valve = false
.step
    T >= 5 s and chamber < 2: -> Idle
