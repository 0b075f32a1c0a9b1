spec 7.12, 7.9  Averages of 2 samples whose sum depends on the order of adding, through several rounds of the window.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 p

[Run]
.step
    avg = roll_avg(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 0.1
G == 1: p = 0.7
G == 2: p = 1e+16
G == 3: p = 1
G == 4: p = -1e+16
G == 5: p = 0.3
G == 6: p = 2.2
G == 7: p = 0.001
G == 8: p = 5.5
G == 9: p = 1000000000000000.0
G == 10: p = -0.6
G == 11: p = 3.3
G == 12: p = 1.1
G == 13: p = 1e+16
G == 14: p = 0.9
G == 15: p = -1e+16
G == 16: p = 0.2
G == 17: p = 0.4
G == 18: p = 7.7
G == 19: p = 100000000000000
G == 20: p = 12.5
G == 21: p = -3.25
G == 22: p = 0.1
G == 22: @stop

-- trace --
1 avg 0x1.999999999999ap-4
2 avg 0x1.9999999999999p-2
3 avg 0x1.1c37937e08p+52
4 avg 0x1.1c37937e08p+52
5 avg -0x1.1c37937e08p+52
6 avg -0x1.1c37937e08p+52
7 avg 0x1.4p+0
8 avg 0x1.19ba5e353f7cfp+0
9 avg 0x1.6010624dd2f1bp+1
10 avg 0x1.c6bf52634002cp+48
11 avg 0x1.c6bf52633fffbp+48
12 avg 0x1.5999999999999p+0
13 avg 0x1.199999999999ap+1
14 avg 0x1.1c37937e08001p+52
15 avg 0x1.1c37937e08p+52
16 avg -0x1.1c37937e08p+52
17 avg -0x1.1c37937e08p+52
18 avg 0x1.3333333333334p-2
19 avg 0x1.0333333333333p+2
20 avg 0x1.6bcc41e9001edp+45
21 avg 0x1.6bcc41e90032p+45
22 avg 0x1.28p+2
23 avg -0x1.9333333333333p+0
