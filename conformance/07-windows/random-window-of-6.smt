spec 7.6, 7.12, 7.16, 7.18  Forty random samples through a window of six.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 median
F64 min
F64 max
F64 range
F64 p

[Run]
.step
    avg = roll_avg(p, 6)
    median = roll_median(p, 6)
    min = roll_min(p, 6)
    max = roll_max(p, 6)
    range = roll_range(p, 6)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = -1.25
G == 1: p = -4.556
G == 2: p = 1.019
G == 3: p = 9.459
G == 4: p = -1.443
G == 5: p = -5.815
G == 6: p = 0.293
G == 7: p = 8.365
G == 8: p = -2.365
G == 9: p = 2.677
G == 10: p = 8.375
G == 11: p = -3.486
G == 12: p = 6.218
G == 13: p = 0.58
G == 14: p = -7.21
G == 15: p = -8.928
G == 16: p = 8.78
G == 17: p = -0.68
G == 18: p = -1.136
G == 19: p = 8.352
G == 20: p = 1.48
G == 21: p = 0.003
G == 22: p = -4.317
G == 23: p = 4.883
G == 24: p = -4.875
G == 25: p = -0.59
G == 26: p = 5.171
G == 27: p = 2.097
G == 28: p = -7.316
G == 29: p = -5.946
G == 30: p = 3.9
G == 31: p = 4.58
G == 32: p = -7.948
G == 33: p = 9.95
G == 34: p = -7.332
G == 35: p = -6.646
G == 36: p = -8.205
G == 37: p = -1.072
G == 38: p = 2.393
G == 39: p = 7.146
G == 39: @stop

-- trace --
1 avg -0x1.4p+0
1 max -0x1.4p+0
1 median -0x1.4p+0
1 min -0x1.4p+0
1 range 0x0p+0
2 avg -0x1.7395810624dd3p+1
2 max -0x1.4p+0
2 median -0x1.7395810624dd3p+1
2 min -0x1.2395810624dd3p+2
2 range 0x1.a72b020c49ba6p+1
3 avg -0x1.987d9c54a6921p+0
3 max 0x1.04dd2f1a9fbe7p+0
3 median -0x1.4p+0
3 min -0x1.2395810624dd3p+2
3 range 0x1.64ccccccccccdp+2
4 avg 0x1.2b020c49ba5e3p+0
4 max 0x1.2eb020c49ba5ep+3
4 median -0x1.d916872b020cp-4
4 min -0x1.2395810624dd3p+2
4 range 0x1.c07ae147ae148p+3
5 avg 0x1.4aa64c2f837b4p-1
5 max 0x1.2eb020c49ba5ep+3
5 median -0x1.4p+0
5 min -0x1.2395810624dd3p+2
5 range 0x1.c07ae147ae148p+3
6 avg -0x1.b95810624dd33p-2
6 max 0x1.2eb020c49ba5ep+3
6 median -0x1.58b4395810625p+0
6 min -0x1.7428f5c28f5c3p+2
6 range 0x1.e8c49ba5e354p+3
7 avg -0x1.6402bb0cf87ep-3
7 max 0x1.2eb020c49ba5ep+3
7 median -0x1.2666666666667p-1
7 min -0x1.7428f5c28f5c3p+2
7 range 0x1.e8c49ba5e354p+3
8 avg 0x1.facb6f46508dfp+0
8 max 0x1.2eb020c49ba5ep+3
8 median 0x1.4fdf3b645a1cap-1
8 min -0x1.7428f5c28f5c3p+2
8 range 0x1.e8c49ba5e354p+3
9 avg 0x1.6a6921735ee3fp+0
9 max 0x1.2eb020c49ba5ep+3
9 median -0x1.2666666666667p-1
9 min -0x1.7428f5c28f5c3p+2
9 range 0x1.e8c49ba5e354p+3
10 avg 0x1.242e6bdc8057p-2
10 max 0x1.0bae147ae147bp+3
10 median -0x1.2666666666667p-1
10 min -0x1.7428f5c28f5c3p+2
10 range 0x1.c5c28f5c28f5cp+3
11 avg 0x1.ebf258bf258bdp+0
11 max 0x1.0cp+3
11 median 0x1.7c28f5c28f5c2p+0
11 min -0x1.7428f5c28f5c3p+2
11 range 0x1.c6147ae147ae2p+3
12 avg 0x1.27a89e60f04c7p+1
12 max 0x1.0cp+3
12 median 0x1.7c28f5c28f5c2p+0
12 min -0x1.be353f7ced917p+1
12 range 0x1.7b8d4fdf3b646p+3
13 avg 0x1.a60f04c756b2dp+1
13 max 0x1.0cp+3
13 median 0x1.1ca3d70a3d70ap+2
13 min -0x1.be353f7ced917p+1
13 range 0x1.7b8d4fdf3b646p+3
14 avg 0x1.fff513cc1e098p+0
14 max 0x1.0cp+3
14 median 0x1.a0e5604189374p+0
14 min -0x1.be353f7ced917p+1
14 range 0x1.7b8d4fdf3b646p+3
15 avg 0x1.313cc1e098eadp+0
15 max 0x1.0cp+3
15 median 0x1.a0e5604189374p+0
15 min -0x1.cd70a3d70a3d7p+2
15 range 0x1.f2b851eb851ecp+3
16 avg -0x1.7bd194237fa8dp-1
16 max 0x1.0cp+3
16 median -0x1.73f7ced916874p+0
16 min -0x1.1db22d0e56042p+3
16 range 0x1.14d916872b021p+4
17 avg -0x1.594237fa89e65p-1
17 max 0x1.18f5c28f5c28fp+3
17 median -0x1.73f7ced916874p+0
17 min -0x1.1db22d0e56042p+3
17 range 0x1.1b53f7ced9168p+4
18 avg -0x1.a740da740da8p-3
18 max 0x1.18f5c28f5c28fp+3
18 median -0x1.99999999999ap-5
18 min -0x1.1db22d0e56042p+3
18 range 0x1.1b53f7ced9168p+4
19 avg -0x1.6ead65b7a3287p+0
19 max 0x1.18f5c28f5c28fp+3
19 median -0x1.d0e5604189374p-1
19 min -0x1.1db22d0e56042p+3
19 range 0x1.1b53f7ced9168p+4
20 avg -0x1.189374bc6a7f5p-3
20 max 0x1.18f5c28f5c28fp+3
20 median -0x1.d0e5604189374p-1
20 min -0x1.1db22d0e56042p+3
20 range 0x1.1b53f7ced9168p+4
21 avg 0x1.4fb38a94d242ep+0
21 max 0x1.18f5c28f5c28fp+3
21 median 0x1.999999999999ap-2
21 min -0x1.1db22d0e56042p+3
21 range 0x1.1b53f7ced9168p+4
22 avg 0x1.6660f04c756b3p+1
22 max 0x1.18f5c28f5c28fp+3
22 median 0x1.7ba5e353f7ceep-1
22 min -0x1.22d0e56041893p+0
22 range 0x1.3d4fdf3b645a1p+3
23 avg 0x1.3be76c8b43958p-1
23 max 0x1.0b4395810624ep+3
23 median -0x1.5a9fbe76c8b44p-2
23 min -0x1.1449ba5e353f8p+2
23 range 0x1.956872b020c4ap+3
24 avg 0x1.8b4e81b4e81b5p+0
24 max 0x1.0b4395810624ep+3
24 median 0x1.7ba5e353f7ceep-1
24 min -0x1.1449ba5e353f8p+2
24 range 0x1.956872b020c4ap+3
25 avg 0x1.d78d4fdf3b645p-1
25 max 0x1.0b4395810624ep+3
25 median 0x1.7ba5e353f7ceep-1
25 min -0x1.38p+2
25 range 0x1.a74395810624ep+3
26 avg -0x1.237fa89e60f05p-1
26 max 0x1.3883126e978d5p+2
26 median -0x1.2c8b439581062p-2
26 min -0x1.38p+2
26 range 0x1.384189374bc6ap+3
27 avg 0x1.777777777778p-5
27 max 0x1.4af1a9fbe76c9p+2
27 median -0x1.2c8b439581062p-2
27 min -0x1.38p+2
27 range 0x1.4178d4fdf3b64p+3
28 avg 0x1.944f3078263adp-2
28 max 0x1.4af1a9fbe76c9p+2
28 median 0x1.81cac083126e9p-1
28 min -0x1.38p+2
28 range 0x1.4178d4fdf3b64p+3
29 avg -0x1.ae147ae147ad5p-4
29 max 0x1.4af1a9fbe76c9p+2
29 median 0x1.81cac083126e9p-1
29 min -0x1.d4395810624ddp+2
29 range 0x1.8f95810624dd3p+3
30 avg -0x1.e8ead65b7a328p+0
30 max 0x1.4af1a9fbe76c9p+2
30 median -0x1.5dc28f5c28f5cp+1
30 min -0x1.d4395810624ddp+2
30 range 0x1.8f95810624dd3p+3
31 avg -0x1.ca11bfd44f305p-2
31 max 0x1.4af1a9fbe76c9p+2
31 median 0x1.81cac083126e9p-1
31 min -0x1.d4395810624ddp+2
31 range 0x1.8f95810624dd3p+3
32 avg 0x1.a846ff513cc2p-2
32 max 0x1.4af1a9fbe76c9p+2
32 median 0x1.7fced916872bp+1
32 min -0x1.d4395810624ddp+2
32 range 0x1.8f95810624dd3p+3
33 avg -0x1.c5acb6f46508fp+0
33 max 0x1.251eb851eb852p+2
33 median -0x1.ecac083126e98p+0
33 min -0x1.fcac083126e98p+2
33 range 0x1.90e5604189375p+3
34 avg -0x1.da740da740dabp-2
34 max 0x1.3e66666666666p+3
34 median -0x1.05e353f7ced9p+0
34 min -0x1.fcac083126e98p+2
34 range 0x1.1e5e353f7ced9p+4
35 avg -0x1.dd2f1a9fbe76bp-2
35 max 0x1.3e66666666666p+3
35 median -0x1.05e353f7ced9p+0
35 min -0x1.fcac083126e98p+2
35 range 0x1.1e5e353f7ced9p+4
36 avg -0x1.2a53490b9af73p-1
36 max 0x1.3e66666666666p+3
36 median -0x1.5f7ced916872cp+0
36 min -0x1.fcac083126e98p+2
36 range 0x1.1e5e353f7ced9p+4
37 avg -0x1.4cd242e6bdc81p+1
37 max 0x1.3e66666666666p+3
37 median -0x1.bf4bc6a7ef9dbp+2
37 min -0x1.068f5c28f5c29p+3
37 range 0x1.227ae147ae148p+4
38 avg -0x1.c565b7a32847p+1
38 max 0x1.3e66666666666p+3
38 median -0x1.bf4bc6a7ef9dbp+2
38 min -0x1.068f5c28f5c29p+3
38 range 0x1.227ae147ae148p+4
39 avg -0x1.d194237fa89e7p+0
39 max 0x1.3e66666666666p+3
39 median -0x1.edf3b645a1cacp+1
39 min -0x1.068f5c28f5c29p+3
39 range 0x1.227ae147ae148p+4
40 avg -0x1.249ba5e353f7dp+1
40 max 0x1.c95810624dd2fp+2
40 median -0x1.edf3b645a1cacp+1
40 min -0x1.068f5c28f5c29p+3
40 range 0x1.eb3b645a1cacp+3
