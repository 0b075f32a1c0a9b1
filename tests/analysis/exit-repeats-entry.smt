# An .exit that switches on what .entry has switched on.  Not one that switches off again, and not one that follows another assignment.
warn no-all exit-repeats-entry

-- app.sm --
[state_vector]
U64  time    @alias G
U32  state   @alias S
bool valve
bool bleed
bool lamp

[Pulse]
.entry
    valve = true
    bleed = false
    lamp = true
.step
    T > 100: lamp = false
    T > 200: -> Soak
.exit
    valve = true                              #! W0917 'valve' is already on: '.entry' of 'Pulse' has switched it on
    bleed = false
    lamp = true

[Soak]
.entry
    valve = false
.step
    T > 2000: -> Pulse
