spec 7.6  An infinity and a 1e300 that have left leave nothing behind.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 median
F64 min
F64 max
F64 range
F64 p

[Run]
.step
    avg = roll_avg(p, 3)
    median = roll_median(p, 3)
    min = roll_min(p, 3)
    max = roll_max(p, 3)
    range = roll_range(p, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1
G == 1: p = 1/0
G == 2: p = 2
G == 3: p = 3
G == 4: p = 4
G == 5: p = 1e+300
G == 6: p = 5
G == 7: p = 6.5
G == 8: p = 7.25
G == 9: p = -1/0
G == 10: p = 1
G == 11: p = 2
G == 12: p = 0.1
G == 13: p = 0.2
G == 13: @stop

-- trace --
1 avg 0x1p+0
1 max 0x1p+0
1 median 0x1p+0
1 min 0x1p+0
1 range 0x0p+0
2 avg inf
2 max inf
2 median inf
2 min 0x1p+0
2 range inf
3 avg inf
3 max inf
3 median 0x1p+1
3 min 0x1p+0
3 range inf
4 avg inf
4 max inf
4 median 0x1.8p+1
4 min 0x1p+1
4 range inf
5 avg 0x1.8p+1
5 max 0x1p+2
5 median 0x1.8p+1
5 min 0x1p+1
5 range 0x1p+1
6 avg 0x1.fdafb60009cdp+994
6 max 0x1.7e43c8800759cp+996
6 median 0x1p+2
6 min 0x1.8p+1
6 range 0x1.7e43c8800759cp+996
7 avg 0x1.fdafb60009cdp+994
7 max 0x1.7e43c8800759cp+996
7 median 0x1.4p+2
7 min 0x1p+2
7 range 0x1.7e43c8800759cp+996
8 avg 0x1.fdafb60009cdp+994
8 max 0x1.7e43c8800759cp+996
8 median 0x1.ap+2
8 min 0x1.4p+2
8 range 0x1.7e43c8800759cp+996
9 avg 0x1.9p+2
9 max 0x1.dp+2
9 median 0x1.ap+2
9 min 0x1.4p+2
9 range 0x1.2p+1
10 avg -inf
10 max 0x1.dp+2
10 median 0x1.ap+2
10 min -inf
10 range inf
11 avg -inf
11 max 0x1.dp+2
11 median 0x1p+0
11 min -inf
11 range inf
12 avg -inf
12 max 0x1p+1
12 median 0x1p+0
12 min -inf
12 range inf
13 avg 0x1.0888888888889p+0
13 max 0x1p+1
13 median 0x1p+0
13 min 0x1.999999999999ap-4
13 range 0x1.e666666666666p+0
14 avg 0x1.8888888888888p-1
14 max 0x1p+1
14 median 0x1.999999999999ap-3
14 min 0x1.999999999999ap-4
14 range 0x1.e666666666666p+0
