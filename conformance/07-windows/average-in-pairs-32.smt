spec 7.12, 7.9, 7.13  Averages of 32 samples, the longest list whose pairs are added in full rounds.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 p

[Run]
.step
    avg = roll_avg(p, 32)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = -0.0
G == 1: p = -0.0
G == 2: p = -0.0
G == 3: p = 1.1
G == 4: p = 1
G == 5: p = 0.3
G == 6: p = 5.5
G == 7: p = 0.3
G == 8: p = -1e+16
G == 9: p = 0.3
G == 10: p = -0.6
G == 11: p = 1e+16
G == 12: p = 1
G == 13: p = 1.1
G == 14: p = 2.2
G == 15: p = -1e+16
G == 16: p = 0.1
G == 17: p = 0.1
G == 18: p = 1e+16
G == 19: p = 2.2
G == 20: p = 1
G == 21: p = 1
G == 22: p = 1e+16
G == 23: p = 5.5
G == 24: p = 0.3
G == 25: p = 5.5
G == 26: p = 0.3
G == 27: p = 5.5
G == 28: p = 1e+16
G == 29: p = 1
G == 30: p = 1e+16
G == 31: p = 2.2
G == 32: p = 1e+16
G == 33: p = 0.1
G == 34: p = 0.1
G == 35: p = 0.7
G == 36: p = 2.2
G == 37: p = 1.1
G == 38: p = 1
G == 39: p = 1e+16
G == 40: p = 2.2
G == 41: p = 0.3
G == 42: p = -1e+16
G == 43: p = 0.3
G == 44: p = 5.5
G == 45: p = 3.3
G == 46: p = 1
G == 47: p = 1.1
G == 48: p = 2.2
G == 49: p = 1e+16
G == 50: p = 0.2
G == 51: p = 0.1
G == 52: p = 1e+16
G == 53: p = 2.2
G == 54: p = 1.1
G == 55: p = -1e+16
G == 56: p = 1e+16
G == 57: p = 5.5
G == 58: p = 0.3
G == 59: p = -1e+16
G == 60: p = 1e+15
G == 61: p = 5.5
G == 62: p = 1e+16
G == 63: p = 1
G == 64: p = 1.1
G == 65: p = 0.9
G == 66: p = 1e+16
G == 67: p = 0.1
G == 68: p = 0.1
G == 69: p = 1e+16
G == 70: p = 1e+16
G == 71: p = 1.1
G == 72: p = 1
G == 73: p = 1e+16
G == 74: p = 5.5
G == 75: p = 0.001
G == 76: p = -1e+16
G == 76: @stop

-- trace --
1 avg -0x0p+0
2 avg -0x0p+0
3 avg -0x0p+0
4 avg 0x1.199999999999ap-2
5 avg 0x1.ae147ae147ae2p-2
6 avg 0x1.999999999999bp-2
7 avg 0x1.20ea0ea0ea0eap+0
8 avg 0x1.0666666666666p+0
9 avg -0x1.f9465b8ab8e32p+49
10 avg -0x1.c6bf52633fffap+49
11 avg -0x1.9d681c5a3a2e3p+49
12 avg 0x1.5ddddddddddddp-1
13 avg 0x1.6a56a56a56a56p-1
14 avg 0x1.78af8af8af8afp-1
15 avg 0x1.aaaaaaaaaaaabp-1
16 avg -0x1.1c37937e07ffap+49
17 avg -0x1.0b7f99e007873p+49
18 avg -0x1.f9465b8ab8e2ep+48
19 avg 0x1.435e50d79435ep-1
20 avg 0x1.6666666666666p-1
21 avg 0x1.8618618618618p-1
22 avg 0x1.745d1745d1746p-1
23 avg 0x1.8b6eb6f22164ep+48
24 avg 0x1.7af4c4a80aab8p+48
25 avg 0x1.6bcc41e90000dp+48
26 avg 0x1.5dce3f6009d99p+48
27 avg 0x1.50d9925c7b437p+48
28 avg 0x1.44d1cd22524a5p+48
29 avg 0x1.399e6dc8dcb12p+49
30 avg 0x1.2f2a36ecd555ep+49
31 avg 0x1.b813fd263deffp+49
32 avg 0x1.aa535d3d0c007p+49
33 avg 0x1.1c37937e08004p+50
34 avg 0x1.1c37937e08004p+50
35 avg 0x1.1c37937e08004p+50
36 avg 0x1.1c37937e08004p+50
37 avg 0x1.1c37937e08004p+50
38 avg 0x1.1c37937e08004p+50
39 avg 0x1.1c37937e08003p+50
40 avg 0x1.6345785d8a003p+50
41 avg 0x1.aa535d3d0c003p+50
42 avg 0x1.aa535d3d0c003p+50
43 avg 0x1.6345785d8a003p+50
44 avg 0x1.1c37937e08004p+50
45 avg 0x1.1c37937e08004p+50
46 avg 0x1.1c37937e08004p+50
47 avg 0x1.1c37937e08004p+50
48 avg 0x1.6345785d8a004p+50
49 avg 0x1.6345785d8a005p+50
50 avg 0x1.aa535d3d0c005p+50
51 avg 0x1.6345785d8a005p+50
52 avg 0x1.6345785d8a004p+50
53 avg 0x1.aa535d3d0c004p+50
54 avg 0x1.aa535d3d0c004p+50
55 avg 0x1.6345785d8a004p+50
56 avg 0x1.1c37937e08004p+50
57 avg 0x1.6345785d8a004p+50
58 avg 0x1.6345785d8a004p+50
59 avg 0x1.6345785d8a004p+50
60 avg 0x1.1c37937e08004p+50
61 avg 0x1.b88957d026008p+49
62 avg 0x1.b88957d026009p+49
63 avg 0x1.b88957d026009p+49
64 avg 0x1.b88957d026008p+49
65 avg 0x1.2a6d8e1122008p+49
66 avg 0x1.2a6d8e1122008p+49
67 avg 0x1.b88957d026009p+49
68 avg 0x1.b88957d026009p+49
69 avg 0x1.b88957d026008p+49
70 avg 0x1.235290c795004p+50
71 avg 0x1.6a6075a717004p+50
72 avg 0x1.235290c795004p+50
73 avg 0x1.235290c795004p+50
74 avg 0x1.6a6075a717004p+50
75 avg 0x1.b16e5a8699004p+50
76 avg 0x1.b16e5a8699004p+50
77 avg 0x1.6a6075a717004p+50
