spec 7.19, 7.16  The median of −0 and 0 is the smaller, since they are equal.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 min
F64 max
F64 median
F64 p

[Run]
.step
    min = roll_min(p, 2)
    max = roll_max(p, 2)
    median = roll_median(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 0
G == 1: p = -0.0
G == 2: p = -0.0
G == 3: p = 0
G == 4: p = 0
G == 4: @stop

-- trace --
1 max 0x0p+0
1 median 0x0p+0
1 min 0x0p+0
2 max 0x0p+0
2 median -0x0p+0
2 min -0x0p+0
3 max -0x0p+0
3 median -0x0p+0
3 min -0x0p+0
4 max 0x0p+0
4 median -0x0p+0
4 min -0x0p+0
5 max 0x0p+0
5 median 0x0p+0
5 min 0x0p+0
