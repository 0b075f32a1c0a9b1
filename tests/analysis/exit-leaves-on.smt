# One way out of a state leaves on what another one switches off; the next state does not decide about it.
warn no-all exit-leaves-on

-- app.sm --
[state_vector]
U64 G
U32 S
bool go @read_only
bool cancel @read_only
F32 pressure @read_only @range 0 100
bool pressValve
bool ventValve
bool purgeValve
[Idle] @safe
.entry
    pressValve = false
    ventValve = false
    purgeValve = false
.step
    go: -> Pressurise
[Pressurise]
.entry
    pressValve = true
.step
    cancel: -> Vent                     #! W0923 'pressValve' stays on when this transition leads to 'Vent'
    pressure > 52 {
        pressValve = false
        -> Armed
    }
    T > 9000 {
        pressValve = 0
        -> Vent
    }
[Armed]
.step
    cancel: -> Vent
    T > 5000: -> Vent
[Vent]
.entry
    ventValve = true
.step
    pressure < 2: -> Idle
