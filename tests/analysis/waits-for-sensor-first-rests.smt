# The first state, where it switches nothing on.
warn no-all waits-for-sensor
-- rests.sm --
[state_vector]
U64  G
U32  S
F32  alt   @read_only @range -50 9000
bool vent
[Wait]
.entry
    vent = false
.step
    alt > 300: -> Up
[Up] @safe
