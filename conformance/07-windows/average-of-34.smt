spec 7.12, 7.9, 7.13  Averages of 34 samples of one size; each sample affects the average.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 p

[Run]
.step
    avg = roll_avg(p, 34)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 0.5
G == 1: p = -3
G == 2: p = -0.5
G == 3: p = 2.75
G == 4: p = 2.75
G == 5: p = 11
G == 6: p = -3
G == 7: p = 0.5
G == 8: p = 0.5
G == 9: p = -3
G == 10: p = -3
G == 11: p = 2.75
G == 12: p = 2.75
G == 13: p = -0.5
G == 14: p = -3
G == 15: p = 4
G == 16: p = 0.5
G == 17: p = -3
G == 18: p = -0.5
G == 19: p = 2.75
G == 20: p = 2.75
G == 21: p = -0.5
G == 22: p = -3
G == 23: p = 0.5
G == 24: p = 0.5
G == 25: p = 1.25
G == 26: p = -0.5
G == 27: p = 2.75
G == 28: p = 2.75
G == 29: p = -0.5
G == 30: p = -0.5
G == 31: p = 0.5
G == 32: p = 0.5
G == 33: p = -3
G == 34: p = -0.5
G == 35: p = 7
G == 36: p = 2.75
G == 37: p = -0.5
G == 38: p = -3
G == 39: p = 0.5
G == 40: p = 0.5
G == 41: p = -3
G == 42: p = -0.5
G == 43: p = 2.75
G == 44: p = 2.75
G == 45: p = 11
G == 46: p = -3
G == 47: p = 0.5
G == 48: p = 0.5
G == 49: p = -3
G == 50: p = -3
G == 51: p = 2.75
G == 52: p = 2.75
G == 53: p = -0.5
G == 54: p = -3
G == 55: p = 4
G == 56: p = 0.5
G == 57: p = -3
G == 58: p = -0.5
G == 59: p = 2.75
G == 60: p = 2.75
G == 61: p = -0.5
G == 62: p = -3
G == 63: p = 0.5
G == 64: p = 0.5
G == 65: p = 1.25
G == 66: p = -0.5
G == 67: p = 2.75
G == 68: p = 2.75
G == 69: p = -0.5
G == 70: p = -0.5
G == 71: p = 0.5
G == 72: p = 0.5
G == 73: p = -3
G == 74: p = -0.5
G == 74: @stop

-- trace --
1 avg 0x1p-1
2 avg -0x1.4p+0
3 avg -0x1p+0
4 avg -0x1p-4
5 avg 0x1p-1
6 avg 0x1.2p+1
7 avg 0x1.8p+0
8 avg 0x1.6p+0
9 avg 0x1.471c71c71c71cp+0
10 avg 0x1.b333333333333p-1
11 avg 0x1p-1
12 avg 0x1.6p-1
13 avg 0x1.b13b13b13b13bp-1
14 avg 0x1.8p-1
15 avg 0x1p-1
16 avg 0x1.7p-1
17 avg 0x1.6969696969697p-1
18 avg 0x1p-1
19 avg 0x1.ca1af286bca1bp-2
20 avg 0x1.2p-1
21 avg 0x1.5555555555555p-1
22 avg 0x1.3a2e8ba2e8ba3p-1
23 avg 0x1.d37a6f4de9bd3p-2
24 avg 0x1.d555555555555p-2
25 avg 0x1.d70a3d70a3d71p-2
26 avg 0x1.f627627627627p-2
27 avg 0x1.d097b425ed098p-2
28 avg 0x1.1249249249249p-1
29 avg 0x1.39611a7b9611ap-1
30 avg 0x1.2666666666666p-1
31 avg 0x1.14a5294a5294ap-1
32 avg 0x1.14p-1
33 avg 0x1.1364d9364d936p-1
34 avg 0x1.bc3c3c3c3c3c4p-2
35 avg 0x1.9e1e1e1e1e1e2p-2
36 avg 0x1.65a5a5a5a5a5ap-1
37 avg 0x1.9696969696969p-1
38 avg 0x1.65a5a5a5a5a5ap-1
39 avg 0x1.0f0f0f0f0f0f1p-1
40 avg 0x1.c3c3c3c3c3c3cp-3
41 avg 0x1.4b4b4b4b4b4b5p-2
42 avg 0x1.c3c3c3c3c3c3cp-3
43 avg 0x1.8787878787878p-3
44 avg 0x1.70f0f0f0f0f0fp-2
45 avg 0x1.0f0f0f0f0f0f1p-1
46 avg 0x1.8b4b4b4b4b4b5p-1
47 avg 0x1.34b4b4b4b4b4bp-1
48 avg 0x1.43c3c3c3c3c3cp-1
49 avg 0x1.7878787878788p-1
50 avg 0x1.0f0f0f0f0f0f1p-1
51 avg 0x1.b4b4b4b4b4b4bp-2
52 avg 0x1.30f0f0f0f0f0fp-1
53 avg 0x1.61e1e1e1e1e1ep-1
54 avg 0x1.30f0f0f0f0f0fp-1
55 avg 0x1.b4b4b4b4b4b4bp-2
56 avg 0x1.1e1e1e1e1e1e2p-1
57 avg 0x1.52d2d2d2d2d2dp-1
58 avg 0x1.1e1e1e1e1e1e2p-1
59 avg 0x1.0f0f0f0f0f0f1p-1
60 avg 0x1.25a5a5a5a5a5ap-1
61 avg 0x1.5696969696969p-1
62 avg 0x1.25a5a5a5a5a5ap-1
63 avg 0x1.9e1e1e1e1e1e2p-2
64 avg 0x1.bc3c3c3c3c3c4p-2
65 avg 0x1.da5a5a5a5a5a6p-2
66 avg 0x1.f0f0f0f0f0f0fp-2
67 avg 0x1.d2d2d2d2d2d2dp-2
68 avg 0x1.4p-1
69 avg 0x1.70f0f0f0f0f0fp-1
70 avg 0x1p-1
71 avg 0x1.9e1e1e1e1e1e2p-2
72 avg 0x1.bc3c3c3c3c3c4p-2
73 avg 0x1.12d2d2d2d2d2dp-1
74 avg 0x1.bc3c3c3c3c3c4p-2
75 avg 0x1.9e1e1e1e1e1e2p-2
