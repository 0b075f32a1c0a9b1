# Handed over on purpose, switched off later by every way, off before it is left, or only told and not driven.
warn no-all output-left-on

-- app.sm --
[state_vector]
U64 G
U32 S
bool run @read_only
F32 level @read_only
bool valve
bool igniter
bool charge
U8   throttle
U8   phase
[Idle]
.entry
    valve = false
    igniter = false
    throttle = 0
    phase = 0
.step
    run: -> Light
[Light]
.entry
    phase = 1
    igniter = true
    valve = true
.step
    level > 5: -> Burn
    T > 1000: -> Abort
[Burn]                              # the valve stays open; every way on from here shuts it
.entry
    phase = 2
    igniter = false
    throttle = 100
    charge = true
.step
    T >= 200: charge = false
    T > 3000: -> Tail
    level < 1: -> Abort
[Tail]
.entry
    throttle = 40
.step
    T > 500: -> Idle
    level < 1: -> Abort
[Abort] @abort
.entry
    valve = false
    igniter = false
    throttle = 0
    charge = false
    phase = 3
.step
    not run: -> Idle
