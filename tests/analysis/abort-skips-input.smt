# One state between others that abort on the button does not, and all abort on the door, one through a local; the last one, whose successor is safe, may have no need to.
warn no-all abort-skips-input

-- app.sm --
[state_vector]
U64 G
U32 S
bool go @read_only
bool stop @read_only
bool door @read_only
F32 pressure @read_only @range 0 100
bool valve
bool igniter
[define]
halted = held(stop, 5 steps)
[local]
bool opened = false
[Idle] @safe
.entry
    valve = false
    igniter = false
.step
    go: -> Fill
[all_states] @except Idle Light Vent Abort
.step
    halted: -> Abort
    door: opened = true
[Fill]
.entry
    valve = true
.step
    pressure > 52: -> Hold
    T > 5000: -> Abort
    door or opened: -> Abort
[Hold]
.step
    T > 3000: -> Light
    door or opened: -> Abort
[Light]                                 #! W0909 'Light' does not abort on 'stop', which aborts 3 other states
.entry
    igniter = true
.step
    T > 500: -> Burn
    pressure > 90 or opened: -> Abort
[Burn]
.step
    T > 4000: -> Vent
    door or opened: -> Abort
.exit
    igniter = false
[Vent]
.step
    pressure < 2: -> Idle
[Abort] @abort @safe
.entry
    valve = false
    igniter = false
