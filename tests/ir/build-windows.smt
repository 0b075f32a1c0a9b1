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
machine "w"
vector "w" size 32 hash 0x751b84b9

element U64 G at 0 is G
element U32 S at 8 is S
element F32 accel at 12
element bool armed at 16
element F64 smooth writable at 24
local F64 peak writable = 0xfff0000000000000  # -inf
time U64 T
window w0 F64 size 5 stats median
window w1 F64 size 3 stats max range
window w2 F64 size 4 stats min
window w3 F64 size 10 stats avg max
window w4 F64 size 1 stats median
window w5 F64 size 9 stats avg

sample {
b0:
    %0 = load F32 accel
    %1 = cvt F64 %0
    sample w0, %1
    %2 = stat median w0
    sample w1, %2
    %3 = load bool armed
    %4 = cvt F64 %3
    sample w2, %4
    %5 = load F32 accel
    %6 = cvt F64 %5
    %7 = const F64 0x40239d013a92a305  # 9.80665
    %8 = mul F64 %6, %7
    sample w3, %8
    %9 = load U64 G
    %10 = cvt F64 %9
    sample w4, %10
    %11 = load F32 accel
    %12 = cvt F64 %11
    %13 = const F64 0x40239d013a92a305  # 9.80665
    %14 = mul F64 %12, %13
    sample w5, %14
    ret
}

state Boost
step {
b0:
    %0 = stat range w1
    %1 = const F64 0x3fe0000000000000  # 0.5
    %2 = gt F64 %0, %1
    %3 = stat min w2
    %4 = cvt bool %3
    %5 = and %2, %4
    br %5, b1, b2
b1:
    goto Coast
b2:
    %6 = stat avg w3
    %7 = cvt F64 %6
    store F64 smooth, %7
    %8 = load F64 peak
    %9 = stat max w3
    %10 = max F64 %8, %9
    %11 = cvt F64 %10
    store F64 peak, %11
    ret
}

state Coast
entry {
b0:
    %0 = stat median w0
    %1 = stat median w4
    %2 = add F64 %0, %1
    %3 = stat max w1
    %4 = add F64 %2, %3
    %5 = stat avg w5
    %6 = add F64 %4, %5
    %7 = cvt F64 %6
    store F64 smooth, %7
    ret
}
