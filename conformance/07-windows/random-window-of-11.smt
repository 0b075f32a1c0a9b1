spec 7.6, 7.12, 7.15, 7.18  Sixty random samples, some repeated, through a window of eleven.

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
    avg = roll_avg(p, 11)
    median = roll_median(p, 11)
    min = roll_min(p, 11)
    max = roll_max(p, 11)
    range = roll_range(p, 11)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = -0.42857142857142855
G == 1: p = 2
G == 2: p = -0.14285714285714285
G == 3: p = -0.14285714285714285
G == 4: p = 0
G == 5: p = -0.7142857142857143
G == 6: p = 3
G == 7: p = -2
G == 8: p = 0
G == 9: p = 1.3333333333333333
G == 10: p = 1.6666666666666667
G == 11: p = 0.42857142857142855
G == 12: p = -0.14285714285714285
G == 13: p = 0
G == 14: p = -1
G == 15: p = 1
G == 16: p = -0.3333333333333333
G == 17: p = 0
G == 18: p = -0.14285714285714285
G == 19: p = -0.2857142857142857
G == 20: p = -5
G == 21: p = 2
G == 22: p = -0.3333333333333333
G == 23: p = 1.6666666666666667
G == 24: p = 0.14285714285714285
G == 25: p = 1.6666666666666667
G == 26: p = 0
G == 27: p = 0.42857142857142855
G == 28: p = 0
G == 29: p = 4
G == 30: p = -0.42857142857142855
G == 31: p = 0.2857142857142857
G == 32: p = -0.7142857142857143
G == 33: p = 0.6666666666666666
G == 34: p = 0
G == 35: p = -0.2857142857142857
G == 36: p = -1.6666666666666667
G == 37: p = -0.5714285714285714
G == 38: p = -2
G == 39: p = -0.42857142857142855
G == 40: p = -0.2857142857142857
G == 41: p = 0.14285714285714285
G == 42: p = -1.3333333333333333
G == 43: p = 0.14285714285714285
G == 44: p = -0.2857142857142857
G == 45: p = -1
G == 46: p = -0.2857142857142857
G == 47: p = -0.2857142857142857
G == 48: p = -0.5714285714285714
G == 49: p = 1
G == 50: p = 0.14285714285714285
G == 51: p = -1
G == 52: p = -1.3333333333333333
G == 53: p = 0.42857142857142855
G == 54: p = 1
G == 55: p = 0.7142857142857143
G == 56: p = -1.6666666666666667
G == 57: p = 3
G == 58: p = -1
G == 59: p = -1.6666666666666667
G == 59: @stop

-- trace --
1 avg -0x1.b6db6db6db6dbp-2
1 max -0x1.b6db6db6db6dbp-2
1 median -0x1.b6db6db6db6dbp-2
1 min -0x1.b6db6db6db6dbp-2
1 range 0x0p+0
2 avg 0x1.9249249249249p-1
2 max 0x1p+1
2 median 0x1.9249249249248p-1
2 min -0x1.b6db6db6db6dbp-2
2 range 0x1.36db6db6db6dbp+1
3 avg 0x1.e79e79e79e79fp-2
3 max 0x1p+1
3 median -0x1.2492492492492p-3
3 min -0x1.b6db6db6db6dbp-2
3 range 0x1.36db6db6db6dbp+1
4 avg 0x1.4924924924924p-2
4 max 0x1p+1
4 median -0x1.2492492492492p-3
4 min -0x1.b6db6db6db6dbp-2
4 range 0x1.36db6db6db6dbp+1
5 avg 0x1.075075075075p-2
5 max 0x1p+1
5 median -0x1.2492492492492p-3
5 min -0x1.b6db6db6db6dbp-2
5 range 0x1.36db6db6db6dbp+1
6 avg 0x1.8618618618617p-4
6 max 0x1p+1
6 median -0x1.2492492492492p-3
6 min -0x1.6db6db6db6db7p-1
6 range 0x1.5b6db6db6db6ep+1
7 avg 0x1.05397829cbc15p-1
7 max 0x1.8p+1
7 median -0x1.2492492492492p-3
7 min -0x1.6db6db6db6db7p-1
7 range 0x1.db6db6db6db6ep+1
8 avg 0x1.9249249249248p-3
8 max 0x1.8p+1
8 median -0x1.2492492492492p-3
8 min -0x1p+1
8 range 0x1.4p+2
9 avg 0x1.6596596596595p-3
9 max 0x1.8p+1
9 median -0x1.2492492492492p-3
9 min -0x1p+1
9 range 0x1.4p+2
10 avg 0x1.2972972972972p-2
10 max 0x1.8p+1
10 median -0x1.2492492492492p-4
10 min -0x1p+1
10 range 0x1.4p+2
11 avg 0x1.a98ef606a63bdp-2
11 max 0x1.8p+1
11 median 0x0p+0
11 min -0x1p+1
11 range 0x1.4p+2
12 avg 0x1.f959c427e5671p-2
12 max 0x1.8p+1
12 median 0x0p+0
12 min -0x1p+1
12 range 0x1.4p+2
13 avg 0x1.31dec0d4c77bp-2
13 max 0x1.8p+1
13 median 0x0p+0
13 min -0x1p+1
13 range 0x1.4p+2
14 avg 0x1.3f2b3884fcacep-2
14 max 0x1.8p+1
14 median 0x0p+0
14 min -0x1p+1
14 range 0x1.4p+2
15 avg 0x1.dec0d4c77b034p-3
15 max 0x1.8p+1
15 median 0x0p+0
15 min -0x1p+1
15 range 0x1.4p+2
16 avg 0x1.4c77b03531decp-2
16 max 0x1.8p+1
16 median 0x0p+0
16 min -0x1p+1
16 range 0x1.4p+2
17 avg 0x1.6fee44b5bfb91p-2
17 max 0x1.8p+1
17 median 0x0p+0
17 min -0x1p+1
17 range 0x1.4p+2
18 avg 0x1.62a1cd058a874p-4
18 max 0x1.aaaaaaaaaaaabp+0
18 median 0x0p+0
18 min -0x1p+1
18 range 0x1.d555555555556p+1
19 avg 0x1.058a8734162a2p-2
19 max 0x1.aaaaaaaaaaaabp+0
19 median 0x0p+0
19 min -0x1p+0
19 range 0x1.5555555555556p+1
20 avg 0x1.d5e32fa7578cdp-3
20 max 0x1.aaaaaaaaaaaabp+0
20 median 0x0p+0
20 min -0x1p+0
20 range 0x1.5555555555556p+1
21 avg -0x1.62a1cd058a872p-2
21 max 0x1.aaaaaaaaaaaabp+0
21 median -0x1.2492492492492p-3
21 min -0x1.4p+2
21 range 0x1.aaaaaaaaaaaabp+2
22 avg -0x1.439a0b150e682p-2
22 max 0x1p+1
22 median -0x1.2492492492492p-3
22 min -0x1.4p+2
22 range 0x1.cp+2
23 avg -0x1.8a8734162a1cdp-2
23 max 0x1p+1
23 median -0x1.2492492492492p-3
23 min -0x1.4p+2
23 range 0x1.cp+2
24 avg -0x1.c427e567109f7p-3
24 max 0x1p+1
24 median -0x1.2492492492492p-3
24 min -0x1.4p+2
24 range 0x1.cp+2
25 avg -0x1.a98ef606a63bdp-3
25 max 0x1p+1
25 median -0x1.2492492492492p-3
25 min -0x1.4p+2
25 range 0x1.cp+2
26 avg 0x1.1bb4a4046ed2fp-5
26 max 0x1p+1
26 median 0x0p+0
26 min -0x1.4p+2
26 range 0x1.cp+2
27 avg -0x1.cd058a873415dp-5
27 max 0x1p+1
27 median 0x0p+0
27 min -0x1.4p+2
27 range 0x1.cp+2
28 avg 0x1.a98ef606a63d1p-7
28 max 0x1p+1
28 median 0x0p+0
28 min -0x1.4p+2
28 range 0x1.cp+2
29 avg 0x1.a98ef606a63d1p-7
29 max 0x1p+1
29 median 0x0p+0
29 min -0x1.4p+2
29 range 0x1.cp+2
30 avg 0x1.8ef606a63bd83p-2
30 max 0x1p+2
30 median 0x1.2492492492492p-3
30 min -0x1.4p+2
30 range 0x1.2p+3
31 avg 0x1.81a98ef606a64p-2
31 max 0x1p+2
31 median 0x1.2492492492492p-3
31 min -0x1.4p+2
31 range 0x1.2p+3
32 avg 0x1.b6db6db6db6dcp-1
32 max 0x1p+2
32 median 0x1.2492492492492p-2
32 min -0x1.b6db6db6db6dbp-2
32 range 0x1.1b6db6db6db6ep+2
33 avg 0x1.3884fcace214p-1
33 max 0x1p+2
33 median 0x1.2492492492492p-3
33 min -0x1.6db6db6db6db7p-1
33 range 0x1.2db6db6db6db7p+2
34 avg 0x1.67109f959c429p-1
34 max 0x1p+2
34 median 0x1.2492492492492p-2
34 min -0x1.6db6db6db6db7p-1
34 range 0x1.2db6db6db6db7p+2
35 avg 0x1.197d3abc65f4fp-1
35 max 0x1p+2
35 median 0x1.2492492492492p-3
35 min -0x1.6db6db6db6db7p-1
35 range 0x1.2db6db6db6db7p+2
36 avg 0x1.058a8734162a1p-1
36 max 0x1p+2
36 median 0x0p+0
36 min -0x1.6db6db6db6db7p-1
36 range 0x1.2db6db6db6db7p+2
37 avg 0x1.a98ef606a63bdp-3
37 max 0x1p+2
37 median 0x0p+0
37 min -0x1.aaaaaaaaaaaabp+0
37 range 0x1.6aaaaaaaaaaabp+2
38 avg 0x1.3f2b3884fcacdp-3
38 max 0x1p+2
38 median 0x0p+0
38 min -0x1.aaaaaaaaaaaabp+0
38 range 0x1.6aaaaaaaaaaabp+2
39 avg -0x1.09f959c427e57p-4
39 max 0x1p+2
39 median -0x1.2492492492492p-2
39 min -0x1p+1
39 range 0x1.8p+2
40 avg -0x1.a98ef606a63bdp-4
40 max 0x1p+2
40 median -0x1.b6db6db6db6dbp-2
40 min -0x1p+1
40 range 0x1.8p+2
41 avg -0x1.f959c427e5671p-2
41 max 0x1.5555555555555p-1
41 median -0x1.b6db6db6db6dbp-2
41 min -0x1p+1
41 range 0x1.5555555555555p+1
42 avg -0x1.c427e567109f9p-2
42 max 0x1.5555555555555p-1
42 median -0x1.2492492492492p-2
42 min -0x1p+1
42 range 0x1.5555555555555p+1
43 avg -0x1.2d6fee44b5bfcp-1
43 max 0x1.5555555555555p-1
43 median -0x1.b6db6db6db6dbp-2
43 min -0x1p+1
43 range 0x1.5555555555555p+1
44 avg -0x1.058a8734162a1p-1
44 max 0x1.5555555555555p-1
44 median -0x1.2492492492492p-2
44 min -0x1p+1
44 range 0x1.5555555555555p+1
45 avg -0x1.31dec0d4c77bp-1
45 max 0x1.2492492492492p-3
45 median -0x1.2492492492492p-2
45 min -0x1p+1
45 range 0x1.1249249249249p+1
46 avg -0x1.606a63bd81a99p-1
46 max 0x1.2492492492492p-3
46 median -0x1.b6db6db6db6dbp-2
46 min -0x1p+1
46 range 0x1.1249249249249p+1
47 avg -0x1.606a63bd81a99p-1
47 max 0x1.2492492492492p-3
47 median -0x1.b6db6db6db6dbp-2
47 min -0x1p+1
47 range 0x1.1249249249249p+1
48 avg -0x1.20237694808ddp-1
48 max 0x1.2492492492492p-3
48 median -0x1.2492492492492p-2
48 min -0x1p+1
48 range 0x1.1249249249249p+1
49 avg -0x1.20237694808ddp-1
49 max 0x1.2492492492492p-3
49 median -0x1.2492492492492p-2
49 min -0x1p+1
49 range 0x1.1249249249249p+1
50 avg -0x1.29011bb4a4046p-2
50 max 0x1p+0
50 median -0x1.2492492492492p-2
50 min -0x1.5555555555555p+0
50 range 0x1.2aaaaaaaaaaaap+1
51 avg -0x1.e79e79e79e79dp-3
51 max 0x1p+0
51 median -0x1.2492492492492p-2
51 min -0x1.5555555555555p+0
51 range 0x1.2aaaaaaaaaaaap+1
52 avg -0x1.364d9364d9364p-2
52 max 0x1p+0
52 median -0x1.2492492492492p-2
52 min -0x1.5555555555555p+0
52 range 0x1.2aaaaaaaaaaaap+1
53 avg -0x1.bfb912d6fee44p-2
53 max 0x1p+0
53 median -0x1.2492492492492p-2
53 min -0x1.5555555555555p+0
53 range 0x1.2aaaaaaaaaaaap+1
54 avg -0x1.1bb4a4046ed29p-2
54 max 0x1p+0
54 median -0x1.2492492492492p-2
54 min -0x1.5555555555555p+0
54 range 0x1.2aaaaaaaaaaaap+1
55 avg -0x1.97d3abc65f4eap-3
55 max 0x1p+0
55 median -0x1.2492492492492p-2
55 min -0x1.5555555555555p+0
55 range 0x1.2aaaaaaaaaaaap+1
56 avg -0x1.bb4a4046ed28fp-4
56 max 0x1p+0
56 median -0x1.2492492492492p-2
56 min -0x1.5555555555555p+0
56 range 0x1.2aaaaaaaaaaaap+1
57 avg -0x1.59c427e567109p-3
57 max 0x1p+0
57 median -0x1.2492492492492p-2
57 min -0x1.aaaaaaaaaaaabp+0
57 range 0x1.5555555555556p+1
58 avg 0x1.09f959c427e57p-3
58 max 0x1.8p+1
58 median 0x1.2492492492492p-3
58 min -0x1.aaaaaaaaaaaabp+0
58 range 0x1.2aaaaaaaaaaabp+2
59 avg 0x1.09f959c427e56p-4
59 max 0x1.8p+1
59 median 0x1.2492492492492p-3
59 min -0x1.aaaaaaaaaaaabp+0
59 range 0x1.2aaaaaaaaaaabp+2
60 avg -0x1.1bb4a4046ed2cp-5
60 max 0x1.8p+1
60 median 0x1.2492492492492p-3
60 min -0x1.aaaaaaaaaaaabp+0
60 range 0x1.2aaaaaaaaaaabp+2
