spec 7.16  The median of an even number of samples is half-way between the middle two, a + (b - a) / 2.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 median
F64 p

[Run]
.step
    median = roll_median(p, 4)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 5
G == 1: p = 1
G == 2: p = 0.1
G == 3: p = 0.7
G == 4: p = 1e+16
G == 5: p = 3
G == 6: p = 1e-300
G == 7: p = 7
G == 8: p = 7
G == 9: p = -0.1
G == 10: p = -0.3
G == 11: p = 5e-324
G == 12: p = 1.5e-323
G == 13: p = 0
G == 13: @stop

-- trace --
1 median 0x1.4p+2
2 median 0x1.8p+1
3 median 0x1p+0
4 median 0x1.b333333333333p-1
5 median 0x1.b333333333333p-1
6 median 0x1.d999999999999p+0
7 median 0x1.d999999999999p+0
8 median 0x1.4p+2
9 median 0x1.4p+2
10 median 0x1.cp+1
11 median 0x1.b999999999999p+1
12 median -0x1.999999999999ap-5
13 median -0x1.999999999999ap-5
14 median 0x0p+0
