spec 7.15  The median of an odd number of samples is the middle one, never rounded.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 median
F64 p

[Run]
.step
    median = roll_median(p, 5)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 5
G == 1: p = 1
G == 2: p = 0.1
G == 3: p = 1e+300
G == 4: p = -3
G == 5: p = 0.1
G == 6: p = 7
G == 7: p = 7
G == 8: p = -1e+300
G == 9: p = 2.5
G == 10: p = 0.3
G == 11: p = 1/0
G == 12: p = -1/0
G == 13: p = 1
G == 13: @stop

-- trace --
1 median 0x1.4p+2
2 median 0x1.8p+1
3 median 0x1p+0
4 median 0x1.8p+1
5 median 0x1p+0
6 median 0x1.999999999999ap-4
7 median 0x1.999999999999ap-4
8 median 0x1.cp+2
9 median 0x1.999999999999ap-4
10 median 0x1.4p+1
11 median 0x1.4p+1
12 median 0x1.4p+1
13 median 0x1.3333333333333p-2
14 median 0x1p+0
