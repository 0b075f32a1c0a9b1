# Where it is known how far time advances in a step, a limit to T is so many steps: 6000 are 60 of 100.
warn window-not-full no-time-unit
advance 100
-- app.sm --
[state_vector]
U64 G
U32 S
F32 wind @read_only
[Hold]
.step
    T > 6000 and roll_avg(wind, 600) < 5: -> Load        #! W0965 of 600 samples
    T > 6000 and roll_avg(wind, 62) > 50: -> Load
[Load]
.step
    T > 5950 and roll_avg(wind, 61) < 4: -> Hold
    T > 20: -> Hold
