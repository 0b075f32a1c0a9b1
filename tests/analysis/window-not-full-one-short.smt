# One sample that is missing can still decide.
warn window-not-full no-time-unit
advance 100
-- app.sm --
[state_vector]
U64 G
U32 S
F32 wind @read_only
[Hold]
.step
    T > 6000 and roll_avg(wind, 63) < 5: -> Load         #! W0965 has 62 of 63
[Load]
.step
    T > 20: -> Hold
