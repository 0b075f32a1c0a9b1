# A state between states that abort on a condition, without an abort that depends on the same sensors.  Not reported: a state that follows one
# without the abort, a state with another abort on the sensor, and a state that [all_states] excepts.
warn no-all abort-skips-input

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time    @alias G
U32  state   @alias S
F32  chamber @read_only @range 0.5 60
F32  tank    @read_only @range 0.5 80
bool go      @read_only @command
bool oxValve
bool fuelValve

[define]
high = chamber > 42

[all_states] @except Idle FuelOpen Abort
.step
    tank > 60: -> Abort

[Idle] @safe
.entry
    oxValve = false
    fuelValve = false
.step
    go: -> Light

[Light]
.entry
    oxValve = true
.step
    chamber > 5: -> OxLead
    T > 500 ms: -> Abort

[OxLead]
.step
    high: -> Abort
    T > 150 ms: -> FuelOpen

[FuelOpen]                                #! W0910 'FuelOpen' does not abort on 'high', on which
.entry
    fuelValve = true
.step
    T > 600 ms: -> Ramp

[Ramp]
.step
    high: -> Abort
    T > 600 ms: -> Hold

[Hold]
.step
    chamber > 45: -> Abort
    T > 1 s: -> Burn

[Burn]
.step
    high: -> Abort
    T > 5 s: -> Idle

[Abort] @abort @safe
.entry
    oxValve = false
    fuelValve = false
.step
    not go and T > 1 s: -> Idle
