spec 7.11  Division by 49, whose inverse is not exact.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 p

[Run]
.step
    avg = roll_avg(p, 49)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 0
G == 1: p = 1
G == 2: p = 2
G == 3: p = 3
G == 4: p = 4
G == 5: p = 5
G == 6: p = 6
G == 7: p = 0
G == 8: p = 1
G == 9: p = 2
G == 10: p = 3
G == 11: p = 4
G == 12: p = 5
G == 13: p = 6
G == 14: p = 0
G == 15: p = 1
G == 16: p = 2
G == 17: p = 3
G == 18: p = 4
G == 19: p = 5
G == 20: p = 6
G == 21: p = 0
G == 22: p = 1
G == 23: p = 2
G == 24: p = 3
G == 25: p = 4
G == 26: p = 5
G == 27: p = 6
G == 28: p = 0
G == 29: p = 1
G == 30: p = 2
G == 31: p = 3
G == 32: p = 4
G == 33: p = 5
G == 34: p = 6
G == 35: p = 0
G == 36: p = 1
G == 37: p = 2
G == 38: p = 3
G == 39: p = 4
G == 40: p = 5
G == 41: p = 6
G == 42: p = 0
G == 43: p = 1
G == 44: p = 2
G == 45: p = 3
G == 46: p = 4
G == 47: p = 5
G == 48: p = 6
G == 49: p = 0
G == 50: p = 1
G == 51: p = 2
G == 52: p = 3
G == 53: p = 4
G == 54: p = 5
G == 55: p = 6
G == 56: p = 0
G == 57: p = 1
G == 58: p = 2
G == 59: p = 3
G == 59: @stop

-- trace --
1 avg 0x0p+0
2 avg 0x1p-1
3 avg 0x1p+0
4 avg 0x1.8p+0
5 avg 0x1p+1
6 avg 0x1.4p+1
7 avg 0x1.8p+1
8 avg 0x1.5p+1
9 avg 0x1.38e38e38e38e4p+1
10 avg 0x1.3333333333333p+1
11 avg 0x1.3a2e8ba2e8ba3p+1
12 avg 0x1.4aaaaaaaaaaabp+1
13 avg 0x1.6276276276276p+1
14 avg 0x1.8p+1
15 avg 0x1.6666666666666p+1
16 avg 0x1.58p+1
17 avg 0x1.52d2d2d2d2d2dp+1
18 avg 0x1.5555555555555p+1
19 avg 0x1.5e50d79435e51p+1
20 avg 0x1.6cccccccccccdp+1
21 avg 0x1.8p+1
22 avg 0x1.6e8ba2e8ba2e9p+1
23 avg 0x1.642c8590b2164p+1
24 avg 0x1.6p+1
25 avg 0x1.6147ae147ae14p+1
26 avg 0x1.6762762762762p+1
27 avg 0x1.71c71c71c71c7p+1
28 avg 0x1.8p+1
29 avg 0x1.72c234f72c235p+1
30 avg 0x1.6aaaaaaaaaaabp+1
31 avg 0x1.6739ce739ce74p+1
32 avg 0x1.68p+1
33 avg 0x1.6c9b26c9b26cap+1
34 avg 0x1.74b4b4b4b4b4bp+1
35 avg 0x1.8p+1
36 avg 0x1.7555555555555p+1
37 avg 0x1.6eb3e45306eb4p+1
38 avg 0x1.6bca1af286bcap+1
39 avg 0x1.6c4ec4ec4ec4fp+1
40 avg 0x1.7p+1
41 avg 0x1.76a2576a2576ap+1
42 avg 0x1.8p+1
43 avg 0x1.7711dc47711dcp+1
44 avg 0x1.71745d1745d17p+1
45 avg 0x1.6eeeeeeeeeeefp+1
46 avg 0x1.6f4de9bd37a6fp+1
47 avg 0x1.72620ae4c415dp+1
48 avg 0x1.78p+1
49 avg 0x1.8p+1
50 avg 0x1.8p+1
51 avg 0x1.8p+1
52 avg 0x1.8p+1
53 avg 0x1.8p+1
54 avg 0x1.8p+1
55 avg 0x1.8p+1
56 avg 0x1.8p+1
57 avg 0x1.8p+1
58 avg 0x1.8p+1
59 avg 0x1.8p+1
60 avg 0x1.8p+1
