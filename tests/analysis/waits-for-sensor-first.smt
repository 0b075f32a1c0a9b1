# The first state is asked if it switches something on: otherwise nothing has begun that would have to go on.
warn no-all waits-for-sensor
-- drives.sm --
[state_vector]
U64  G
U32  S
F32  alt   @read_only @range -50 9000
bool vent
[Vent]                      #! W0926 'Vent' never ends while 'alt'
.entry
    vent = true
.step
    alt > 300: -> Up
.exit
    vent = false
[Up] @safe
