spec 7.12, 2.2  Windows over an I8, which an implementation may keep as integers, give the same bits.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 median
F64 min
F64 max
F64 range
I8 p

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
G == 0: p = -121
G == 1: p = -31
G == 2: p = -31
G == 3: p = -74
G == 4: p = -40
G == 5: p = 106
G == 6: p = 96
G == 7: p = 112
G == 8: p = 116
G == 9: p = 20
G == 10: p = -90
G == 11: p = -116
G == 12: p = 110
G == 13: p = -24
G == 14: p = -118
G == 15: p = 99
G == 16: p = -25
G == 17: p = -95
G == 18: p = 46
G == 19: p = -26
G == 20: p = -77
G == 21: p = 61
G == 22: p = -83
G == 23: p = -40
G == 24: p = -16
G == 25: p = 74
G == 26: p = -127
G == 27: p = -111
G == 28: p = 91
G == 29: p = -99
G == 30: p = 25
G == 31: p = -32
G == 32: p = 71
G == 33: p = 72
G == 34: p = -43
G == 35: p = -70
G == 36: p = 68
G == 37: p = -32
G == 38: p = -17
G == 39: p = -61
G == 39: @stop

-- trace --
1 avg -0x1.e4p+6
1 max -0x1.e4p+6
1 median -0x1.e4p+6
1 min -0x1.e4p+6
1 range 0x0p+0
2 avg -0x1.3p+6
2 max -0x1.fp+4
2 median -0x1.3p+6
2 min -0x1.e4p+6
2 range 0x1.68p+6
3 avg -0x1.e8p+5
3 max -0x1.fp+4
3 median -0x1.fp+4
3 min -0x1.e4p+6
3 range 0x1.68p+6
4 avg -0x1.01p+6
4 max -0x1.fp+4
4 median -0x1.a4p+5
4 min -0x1.e4p+6
4 range 0x1.68p+6
5 avg -0x1.db33333333333p+5
5 max -0x1.fp+4
5 median -0x1.4p+5
5 min -0x1.e4p+6
5 range 0x1.68p+6
6 avg -0x1.fd55555555555p+4
6 max 0x1.a8p+6
6 median -0x1.1cp+5
6 min -0x1.e4p+6
6 range 0x1.c6p+7
7 avg 0x1.1555555555555p+2
7 max 0x1.a8p+6
7 median -0x1.fp+4
7 min -0x1.28p+6
7 range 0x1.68p+7
8 avg 0x1.c2aaaaaaaaaabp+4
8 max 0x1.cp+6
8 median 0x1.04p+5
8 min -0x1.28p+6
8 range 0x1.74p+7
9 avg 0x1.a555555555555p+5
9 max 0x1.dp+6
9 median 0x1.94p+6
9 min -0x1.28p+6
9 range 0x1.7cp+7
10 avg 0x1.1155555555555p+6
10 max 0x1.dp+6
10 median 0x1.94p+6
10 min -0x1.4p+5
10 range 0x1.38p+7
11 avg 0x1.ep+5
11 max 0x1.dp+6
11 median 0x1.94p+6
11 min -0x1.68p+6
11 range 0x1.9cp+7
12 avg 0x1.7p+4
12 max 0x1.dp+6
12 median 0x1.dp+5
12 min -0x1.dp+6
12 range 0x1.dp+7
13 avg 0x1.9555555555555p+4
13 max 0x1.dp+6
13 median 0x1.04p+6
13 min -0x1.dp+6
13 range 0x1.dp+7
14 avg 0x1.5555555555555p+1
14 max 0x1.dp+6
14 median -0x1p+1
14 min -0x1.dp+6
14 range 0x1.dp+7
15 avg -0x1.22aaaaaaaaaabp+5
15 max 0x1.b8p+6
15 median -0x1.c8p+5
15 min -0x1.d8p+6
15 range 0x1.c8p+7
16 avg -0x1.72aaaaaaaaaabp+4
16 max 0x1.b8p+6
16 median -0x1.c8p+5
16 min -0x1.d8p+6
16 range 0x1.c8p+7
17 avg -0x1.8aaaaaaaaaaabp+3
17 max 0x1.b8p+6
17 median -0x1.88p+4
17 min -0x1.d8p+6
17 range 0x1.c8p+7
18 avg -0x1.1aaaaaaaaaaabp+3
18 max 0x1.b8p+6
18 median -0x1.88p+4
18 min -0x1.d8p+6
18 range 0x1.c8p+7
19 avg -0x1.38p+4
19 max 0x1.8cp+6
19 median -0x1.88p+4
19 min -0x1.d8p+6
19 range 0x1.b2p+7
20 avg -0x1.3d55555555555p+4
20 max 0x1.8cp+6
20 median -0x1.98p+4
20 min -0x1.d8p+6
20 range 0x1.b2p+7
21 avg -0x1.ap+3
21 max 0x1.8cp+6
21 median -0x1.98p+4
21 min -0x1.7cp+6
21 range 0x1.84p+7
22 avg -0x1.3555555555555p+4
22 max 0x1.e8p+5
22 median -0x1.98p+4
22 min -0x1.7cp+6
22 range 0x1.38p+7
23 avg -0x1.dp+4
23 max 0x1.e8p+5
23 median -0x1.9cp+5
23 min -0x1.7cp+6
23 range 0x1.38p+7
24 avg -0x1.3d55555555555p+4
24 max 0x1.e8p+5
24 median -0x1.08p+5
24 min -0x1.4cp+6
24 range 0x1.2p+7
25 avg -0x1.e2aaaaaaaaaabp+4
25 max 0x1.e8p+5
25 median -0x1.08p+5
25 min -0x1.4cp+6
25 range 0x1.2p+7
26 avg -0x1.bp+3
26 max 0x1.28p+6
26 median -0x1.cp+4
26 min -0x1.4cp+6
26 range 0x1.3ap+7
27 avg -0x1.5d55555555555p+4
27 max 0x1.28p+6
27 median -0x1.cp+4
27 min -0x1.fcp+6
27 range 0x1.92p+7
28 avg -0x1.94p+5
28 max 0x1.28p+6
28 median -0x1.ecp+5
28 min -0x1.fcp+6
28 range 0x1.92p+7
29 avg -0x1.58p+4
29 max 0x1.6cp+6
29 median -0x1.cp+4
29 min -0x1.fcp+6
29 range 0x1.b4p+7
30 avg -0x1.f555555555555p+4
30 max 0x1.6cp+6
30 median -0x1.ccp+5
30 min -0x1.fcp+6
30 range 0x1.b4p+7
31 avg -0x1.88p+4
31 max 0x1.6cp+6
31 median -0x1.28p+5
31 min -0x1.fcp+6
31 range 0x1.b4p+7
32 avg -0x1.5155555555555p+5
32 max 0x1.6cp+6
32 median -0x1.06p+6
32 min -0x1.fcp+6
32 range 0x1.b4p+7
33 avg -0x1.2555555555555p+3
33 max 0x1.6cp+6
33 median -0x1.cp+1
33 min -0x1.bcp+6
33 range 0x1.94p+7
34 avg 0x1.5555555555555p+4
34 max 0x1.6cp+6
34 median 0x1.8p+5
34 min -0x1.8cp+6
34 range 0x1.7cp+7
35 avg -0x1p+0
35 max 0x1.2p+6
35 median -0x1.cp+1
35 min -0x1.8cp+6
35 range 0x1.56p+7
36 avg 0x1.eaaaaaaaaaaabp+1
36 max 0x1.2p+6
36 median -0x1.cp+1
36 min -0x1.18p+6
36 range 0x1.1cp+7
37 avg 0x1.6p+3
37 max 0x1.2p+6
37 median 0x1.2p+4
37 min -0x1.18p+6
37 range 0x1.1cp+7
38 avg 0x1.6p+3
38 max 0x1.2p+6
38 median 0x1.2p+4
38 min -0x1.18p+6
38 range 0x1.1cp+7
39 avg -0x1.d555555555555p+1
39 max 0x1.2p+6
39 median -0x1.88p+4
39 min -0x1.18p+6
39 range 0x1.1cp+7
40 avg -0x1.9d55555555555p+4
40 max 0x1.1p+6
40 median -0x1.2cp+5
40 min -0x1.18p+6
40 range 0x1.14p+7
