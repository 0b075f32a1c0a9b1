spec 7.18  Rising, falling and level samples, where a wrong queue would lose one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 min
F64 max
F64 range
F64 p

[Run]
.step
    min = roll_min(p, 4)
    max = roll_max(p, 4)
    range = roll_range(p, 4)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1
G == 1: p = 2
G == 2: p = 3
G == 3: p = 4
G == 4: p = 5
G == 5: p = 4
G == 6: p = 3
G == 7: p = 2
G == 8: p = 1
G == 9: p = 1
G == 10: p = 1
G == 11: p = 2
G == 12: p = 2
G == 13: p = 5
G == 14: p = 5
G == 15: p = 5
G == 16: p = 1
G == 17: p = 0
G == 18: p = 0
G == 19: p = 9
G == 20: p = 8
G == 21: p = 9
G == 22: p = 8
G == 23: p = 9
G == 23: @stop

-- trace --
1 max 0x1p+0
1 min 0x1p+0
1 range 0x0p+0
2 max 0x1p+1
2 min 0x1p+0
2 range 0x1p+0
3 max 0x1.8p+1
3 min 0x1p+0
3 range 0x1p+1
4 max 0x1p+2
4 min 0x1p+0
4 range 0x1.8p+1
5 max 0x1.4p+2
5 min 0x1p+1
5 range 0x1.8p+1
6 max 0x1.4p+2
6 min 0x1.8p+1
6 range 0x1p+1
7 max 0x1.4p+2
7 min 0x1.8p+1
7 range 0x1p+1
8 max 0x1.4p+2
8 min 0x1p+1
8 range 0x1.8p+1
9 max 0x1p+2
9 min 0x1p+0
9 range 0x1.8p+1
10 max 0x1.8p+1
10 min 0x1p+0
10 range 0x1p+1
11 max 0x1p+1
11 min 0x1p+0
11 range 0x1p+0
12 max 0x1p+1
12 min 0x1p+0
12 range 0x1p+0
13 max 0x1p+1
13 min 0x1p+0
13 range 0x1p+0
14 max 0x1.4p+2
14 min 0x1p+0
14 range 0x1p+2
15 max 0x1.4p+2
15 min 0x1p+1
15 range 0x1.8p+1
16 max 0x1.4p+2
16 min 0x1p+1
16 range 0x1.8p+1
17 max 0x1.4p+2
17 min 0x1p+0
17 range 0x1p+2
18 max 0x1.4p+2
18 min 0x0p+0
18 range 0x1.4p+2
19 max 0x1.4p+2
19 min 0x0p+0
19 range 0x1.4p+2
20 max 0x1.2p+3
20 min 0x0p+0
20 range 0x1.2p+3
21 max 0x1.2p+3
21 min 0x0p+0
21 range 0x1.2p+3
22 max 0x1.2p+3
22 min 0x0p+0
22 range 0x1.2p+3
23 max 0x1.2p+3
23 min 0x1p+3
23 range 0x1p+0
24 max 0x1.2p+3
24 min 0x1p+3
24 range 0x1p+0
