spec 7.18  The smallest and the largest sample, infinities included.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 min
F64 max
F64 p

[Run]
.step
    min = roll_min(p, 4)
    max = roll_max(p, 4)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 3
G == 1: p = -1
G == 2: p = 4
G == 3: p = 1e+300
G == 4: p = -1e+300
G == 5: p = 5e-324
G == 6: p = 1/0
G == 7: p = 2
G == 8: p = -1/0
G == 9: p = 0
G == 10: p = 6
G == 11: p = 7
G == 11: @stop

-- trace --
1 max 0x1.8p+1
1 min 0x1.8p+1
2 max 0x1.8p+1
2 min -0x1p+0
3 max 0x1p+2
3 min -0x1p+0
4 max 0x1.7e43c8800759cp+996
4 min -0x1p+0
5 max 0x1.7e43c8800759cp+996
5 min -0x1.7e43c8800759cp+996
6 max 0x1.7e43c8800759cp+996
6 min -0x1.7e43c8800759cp+996
7 max inf
7 min -0x1.7e43c8800759cp+996
8 max inf
8 min -0x1.7e43c8800759cp+996
9 max inf
9 min -inf
10 max inf
10 min -inf
11 max 0x1.8p+2
11 min -inf
12 max 0x1.cp+2
12 min -inf
