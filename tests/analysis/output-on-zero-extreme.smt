# Falling below the highest: it dies in flight.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  altitude @read_only @range -50 12000
bool drogue
[local]
F64 highest = 0
[Ascent]
.step
    highest = max(highest, roll_median(altitude, 9))
    T > 1000 and roll_median(altitude, 9) < highest - 10: -> Drogue     #! W0903 'altitude' alone switches on 'drogue'
    T > 18000: -> Drogue
[Drogue] @safe
.entry
    drogue = true
.step
    T > 1000: drogue = false
