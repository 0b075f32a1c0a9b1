spec 7.19  −0 is smaller than 0 in minimum, maximum and median.

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
    min = roll_min(p, 3)
    max = roll_max(p, 3)
    median = roll_median(p, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 0
G == 1: p = -0.0
G == 2: p = 0
G == 3: p = -0.0
G == 4: p = -0.0
G == 5: p = -0.0
G == 6: p = 0
G == 7: p = 0
G == 8: p = 0
G == 9: p = -0.0
G == 9: @stop

-- trace --
1 max 0x0p+0
1 median 0x0p+0
1 min 0x0p+0
2 max 0x0p+0
2 median -0x0p+0
2 min -0x0p+0
3 max 0x0p+0
3 median 0x0p+0
3 min -0x0p+0
4 max 0x0p+0
4 median -0x0p+0
4 min -0x0p+0
5 max 0x0p+0
5 median -0x0p+0
5 min -0x0p+0
6 max -0x0p+0
6 median -0x0p+0
6 min -0x0p+0
7 max 0x0p+0
7 median -0x0p+0
7 min -0x0p+0
8 max 0x0p+0
8 median 0x0p+0
8 min -0x0p+0
9 max 0x0p+0
9 median 0x0p+0
9 min 0x0p+0
10 max 0x0p+0
10 median 0x0p+0
10 min -0x0p+0
