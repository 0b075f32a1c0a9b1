spec 7.17  When b - a is not finite the median is a / 2 + b / 2.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 median
F64 p

[Run]
.step
    median = roll_median(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1.7e+308
G == 1: p = -1.7e+308
G == 2: p = 1.6e+308
G == 3: p = 1.6e+308
G == 4: p = -1.5e+308
G == 5: p = 1.7976931348623157e+308
G == 6: p = -1.7976931348623157e+308
G == 7: p = 1/0
G == 8: p = 3
G == 9: p = -1/0
G == 10: p = 5
G == 11: p = 1
G == 12: p = 1/0
G == 13: p = 1/0
G == 14: p = -1/0
G == 14: @stop

-- trace --
1 median 0x1.e42d130773b76p+1023
2 median 0x0p+0
3 median -0x1.c7b1f3cac743p+1018
4 median 0x1.c7b1f3cac7433p+1023
5 median 0x1.c7b1f3cac743p+1018
6 median 0x1.5324adc794c3cp+1020
7 median 0x0p+0
8 median inf
9 median inf
10 median -inf
11 median -inf
12 median 0x1.8p+1
13 median inf
14 median inf
15 median 0x0p+0
