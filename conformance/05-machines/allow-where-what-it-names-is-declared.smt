spec 5.51  A warning of -Wflight that names its sensor or its outputs is covered at the declaration of the sensor, or of all the outputs.
warn output-on-zero output-left-on unused-allow

-- app.sv --
[R]
U64 G
U32 S
F64 level
F64 dome
bool heater
bool valve @allow(output-left-on, "stays open by design")
bool lamp
bool vent
-- app.sm --
[state_vector]
U64 G
U32 S
F64 level @read_only
F64 dome @read_only @allow(output-on-zero, "a dead sensor may vent")
bool heater @allow(output-on-zero, "a warm tank is safe")
bool valve
bool lamp
bool vent

[A]
.entry
    valve = true
.step
    level > 50: -> B
[B] @safe
.step
    level < 20: heater = true
    dome < 20: vent = true
    level > 60: -> C
.exit
    heater = false
    vent = false
[C]
.entry
    lamp = true
.step
    T > 100: -> D
[D] @safe                                 #! W0922 'valve' and 'lamp'
