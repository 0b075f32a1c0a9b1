# A flight warning that names a sensor or outputs is covered by an @allow at the declaration of the sensor or of all the outputs.
# What two sensors can do each alone is covered where both are.
# One that covers only some of the outputs does not cover the finding, and is not useless either.
warn flight unused-allow
advance 10

-- app.sm --
[state_vector]
U64  G
U32  S
bool run      @read_only @command
F32  level    @read_only
F32  dome     @read_only   @allow(output-on-zero, "a dead dome sensor may vent")
F32  line     @read_only   @allow(abort-exit, "no such state here") #! W0210 '@allow(abort-exit)'
bool valve    @allow(output-left-on, "stays open by design") @allow(missing-timeout, "an operator watches")
bool lamp     @allow(output-left-on, "only a lamp") @allow(missing-timeout, "only a lamp")
bool heater   @allow(output-on-zero, "a warm tank is safe")
bool vent
bool siren
bool fan
bool pump
bool horn     @allow(output-left-on, "only a horn")
[Idle] @safe
.step
    run: -> Fill
[Fill]
.entry
    valve = true
    lamp = true
.step
    not run: -> Done
[Done] @safe
.step
    run: -> Burn
[Burn]
.entry
    siren = true
    horn = true
.step
    T > 100: -> Rest
[Rest] @safe                       #! W0922 'valve', 'lamp', 'siren' and 'horn' still on
.step
    level < 20: heater = true
    dome < 20: vent = true
    line < 20: fan = true          #! W0903 'line' alone switches on 'fan'
    dome < 20 or line < 20: pump = true     #! W0903 'dome' alone switches on 'pump'
