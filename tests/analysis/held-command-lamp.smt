# A lamp that shows the key, outside the @abort state: no finding, because the machine does not start again.
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
bool lamp

[all_states] @except Idle Abort
.step
    not key: -> Abort
    chamber > 40: -> Abort

[Idle] @safe
.step
    lamp = key
    rising(key): -> Ignite

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
.exit
    valve = false

[Abort] @abort
.entry
    igniter = false
    valve = false
    lamp = false
.step
    T >= 5 s and chamber < 2: -> Idle
