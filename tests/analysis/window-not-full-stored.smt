# What was stored before the window was full decides once it is full.
warn window-not-full
advance 20
-- app.sm --
[state_vector]
U64 G
U32 S
F64 height @read_only @range 0 300
bool drogue
[local]
F64 highest = 0
F64 smooth = 0
[Pad] @safe
.step
    T > 100 and roll_median(height, 9) > 20: -> Ascent       #! W0965 the window of 'roll_median(height, 9)' has 7 of 9 samples
[Ascent]
.step
    smooth = roll_median(height, 9)
    highest = max(highest, smooth)
    20 < smooth < highest - 4: -> Drogue          #! W0965 it reads what was stored before the window of 'roll_median(height, 9)' was full
    T > 12000: -> Drogue
[Drogue] @safe
.entry
    drogue = true
