# The same sample and size share a window, whatever the statistic; inner calls are sampled first.

-- w.sm --
[state_vector]
U64 G
U32 S
F32 accel @read_only
bool armed @read_only
F64 smooth
[local]
F64 g = 9.80665 @read_only
F64 peak = -1/0
[Boost]
.step
    roll_range(roll_median(accel, 5), 3) > 0.5 and roll_min(armed, 4): -> Coast
    smooth = roll_avg(accel * g, 10)
    peak = max(peak, roll_max(accel * g, 5 + 5))
[Coast]
.entry
    smooth = roll_median(accel, 5) + roll_median(G, 1) + roll_max(roll_median(accel, 5), 3) + roll_avg(accel * g, 9)
-- ir out --
