spec 7.18, 7.8  -0 is below +0 for the smallest and the largest sample, also in windows without a median.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F32 q
F64 min3
F64 max3
F64 min6
F64 max6
F32 least
F32 most
F64 min70
F64 max70
F64 range6

[Run]
.step
    min3 = roll_min(p, 3)
    max3 = roll_max(p, 3)
    min6 = roll_min(p, 6)
    max6 = roll_max(p, 6)
    least = roll_min(q, 6)
    most = roll_max(q, 6)
    min70 = roll_min(p, 70)
    max70 = roll_max(p, 70)
    range6 = roll_range(p, 6)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 0
G == 0: q = 0
G == 1: p = -0.0
G == 1: q = -0.0
G == 2: p = 0
G == 2: q = 0
G == 3: p = -0.0
G == 3: q = -0.0
G == 4: p = -0.0
G == 4: q = -0.0
G == 5: p = -0.0
G == 5: q = -0.0
G == 6: p = -0.0
G == 6: q = -0.0
G == 7: p = -0.0
G == 7: q = -0.0
G == 8: p = -0.0
G == 8: q = -0.0
G == 9: p = -0.0
G == 9: q = -0.0
G == 10: p = 0
G == 10: q = 0
G == 11: p = -0.0
G == 11: q = -0.0
G == 12: p = 0
G == 12: q = 0
G == 13: p = 0
G == 13: q = 0
G == 14: p = 0
G == 14: q = 0
G == 15: p = 0
G == 15: q = 0
G == 16: p = 0
G == 16: q = 0
G == 17: p = 0
G == 17: q = 0
G == 18: p = 0
G == 18: q = 0
G == 19: p = -1
G == 19: q = -1
G == 20: p = 2
G == 20: q = 2
G == 21: p = -0.0
G == 21: q = -0.0
G == 22: p = 0
G == 22: q = 0
G == 22: @stop

-- trace --
1 least 0x0p+0
1 max3 0x0p+0
1 max6 0x0p+0
1 max70 0x0p+0
1 min3 0x0p+0
1 min6 0x0p+0
1 min70 0x0p+0
1 most 0x0p+0
1 range6 0x0p+0
2 least -0x0p+0
2 max3 0x0p+0
2 max6 0x0p+0
2 max70 0x0p+0
2 min3 -0x0p+0
2 min6 -0x0p+0
2 min70 -0x0p+0
2 most 0x0p+0
2 range6 0x0p+0
3 least -0x0p+0
3 max3 0x0p+0
3 max6 0x0p+0
3 max70 0x0p+0
3 min3 -0x0p+0
3 min6 -0x0p+0
3 min70 -0x0p+0
3 most 0x0p+0
3 range6 0x0p+0
4 least -0x0p+0
4 max3 0x0p+0
4 max6 0x0p+0
4 max70 0x0p+0
4 min3 -0x0p+0
4 min6 -0x0p+0
4 min70 -0x0p+0
4 most 0x0p+0
4 range6 0x0p+0
5 least -0x0p+0
5 max3 0x0p+0
5 max6 0x0p+0
5 max70 0x0p+0
5 min3 -0x0p+0
5 min6 -0x0p+0
5 min70 -0x0p+0
5 most 0x0p+0
5 range6 0x0p+0
6 least -0x0p+0
6 max3 -0x0p+0
6 max6 0x0p+0
6 max70 0x0p+0
6 min3 -0x0p+0
6 min6 -0x0p+0
6 min70 -0x0p+0
6 most 0x0p+0
6 range6 0x0p+0
7 least -0x0p+0
7 max3 -0x0p+0
7 max6 0x0p+0
7 max70 0x0p+0
7 min3 -0x0p+0
7 min6 -0x0p+0
7 min70 -0x0p+0
7 most 0x0p+0
7 range6 0x0p+0
8 least -0x0p+0
8 max3 -0x0p+0
8 max6 0x0p+0
8 max70 0x0p+0
8 min3 -0x0p+0
8 min6 -0x0p+0
8 min70 -0x0p+0
8 most 0x0p+0
8 range6 0x0p+0
9 least -0x0p+0
9 max3 -0x0p+0
9 max6 -0x0p+0
9 max70 0x0p+0
9 min3 -0x0p+0
9 min6 -0x0p+0
9 min70 -0x0p+0
9 most -0x0p+0
9 range6 0x0p+0
10 least -0x0p+0
10 max3 -0x0p+0
10 max6 -0x0p+0
10 max70 0x0p+0
10 min3 -0x0p+0
10 min6 -0x0p+0
10 min70 -0x0p+0
10 most -0x0p+0
10 range6 0x0p+0
11 least -0x0p+0
11 max3 0x0p+0
11 max6 0x0p+0
11 max70 0x0p+0
11 min3 -0x0p+0
11 min6 -0x0p+0
11 min70 -0x0p+0
11 most 0x0p+0
11 range6 0x0p+0
12 least -0x0p+0
12 max3 0x0p+0
12 max6 0x0p+0
12 max70 0x0p+0
12 min3 -0x0p+0
12 min6 -0x0p+0
12 min70 -0x0p+0
12 most 0x0p+0
12 range6 0x0p+0
13 least -0x0p+0
13 max3 0x0p+0
13 max6 0x0p+0
13 max70 0x0p+0
13 min3 -0x0p+0
13 min6 -0x0p+0
13 min70 -0x0p+0
13 most 0x0p+0
13 range6 0x0p+0
14 least -0x0p+0
14 max3 0x0p+0
14 max6 0x0p+0
14 max70 0x0p+0
14 min3 -0x0p+0
14 min6 -0x0p+0
14 min70 -0x0p+0
14 most 0x0p+0
14 range6 0x0p+0
15 least -0x0p+0
15 max3 0x0p+0
15 max6 0x0p+0
15 max70 0x0p+0
15 min3 0x0p+0
15 min6 -0x0p+0
15 min70 -0x0p+0
15 most 0x0p+0
15 range6 0x0p+0
16 least -0x0p+0
16 max3 0x0p+0
16 max6 0x0p+0
16 max70 0x0p+0
16 min3 0x0p+0
16 min6 -0x0p+0
16 min70 -0x0p+0
16 most 0x0p+0
16 range6 0x0p+0
17 least -0x0p+0
17 max3 0x0p+0
17 max6 0x0p+0
17 max70 0x0p+0
17 min3 0x0p+0
17 min6 -0x0p+0
17 min70 -0x0p+0
17 most 0x0p+0
17 range6 0x0p+0
18 least 0x0p+0
18 max3 0x0p+0
18 max6 0x0p+0
18 max70 0x0p+0
18 min3 0x0p+0
18 min6 0x0p+0
18 min70 -0x0p+0
18 most 0x0p+0
18 range6 0x0p+0
19 least 0x0p+0
19 max3 0x0p+0
19 max6 0x0p+0
19 max70 0x0p+0
19 min3 0x0p+0
19 min6 0x0p+0
19 min70 -0x0p+0
19 most 0x0p+0
19 range6 0x0p+0
20 least -0x1p+0
20 max3 0x0p+0
20 max6 0x0p+0
20 max70 0x0p+0
20 min3 -0x1p+0
20 min6 -0x1p+0
20 min70 -0x1p+0
20 most 0x0p+0
20 range6 0x1p+0
21 least -0x1p+0
21 max3 0x1p+1
21 max6 0x1p+1
21 max70 0x1p+1
21 min3 -0x1p+0
21 min6 -0x1p+0
21 min70 -0x1p+0
21 most 0x1p+1
21 range6 0x1.8p+1
22 least -0x1p+0
22 max3 0x1p+1
22 max6 0x1p+1
22 max70 0x1p+1
22 min3 -0x1p+0
22 min6 -0x1p+0
22 min70 -0x1p+0
22 most 0x1p+1
22 range6 0x1.8p+1
23 least -0x1p+0
23 max3 0x1p+1
23 max6 0x1p+1
23 max70 0x1p+1
23 min3 -0x0p+0
23 min6 -0x1p+0
23 min70 -0x1p+0
23 most 0x1p+1
23 range6 0x1.8p+1
