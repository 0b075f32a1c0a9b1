# The guard names counters before the variable that the statistic is stored in.
warn window-not-full
-- app.sm --
[state_vector]
U64 G
U32 S
F32 wind @read_only
[local]
U32 n = 0
U32 m = 0
bool calm = false
[Hold]
.step
    n = n + 1
    wind > 3: m = n + m + 1
    else: m = m + n
    calm = roll_avg(wind, 63) < 5
    n >= 60 and m >= 0.5 and calm: -> Load          #! W0965 the window of 'roll_avg(wind, 63)' has 60 of 63 samples
[Load]
.entry
    n = 0
.step
    T > 20: -> Hold
