spec 7.12, 2.2  The same over an I32: sums go beyond 32 bits.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 median
F64 min
F64 max
F64 range
I32 p

[Run]
.step
    avg = roll_avg(p, 5)
    median = roll_median(p, 5)
    min = roll_min(p, 5)
    max = roll_max(p, 5)
    range = roll_range(p, 5)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = -210461182
G == 1: p = -2034394712
G == 2: p = 1149621567
G == 3: p = 785705683
G == 4: p = 1128454093
G == 5: p = 1592282653
G == 6: p = 1791638135
G == 7: p = -1328204923
G == 8: p = 1157034524
G == 9: p = 1461466402
G == 10: p = 453557779
G == 11: p = -910439567
G == 12: p = 214615633
G == 13: p = -1804608489
G == 14: p = -1501431256
G == 15: p = 437289100
G == 16: p = -95911904
G == 17: p = 1798411177
G == 18: p = 158698142
G == 19: p = -1414392689
G == 20: p = 1386398640
G == 21: p = -1161273660
G == 22: p = -881942388
G == 23: p = 158781349
G == 24: p = -1204203788
G == 25: p = 405490506
G == 26: p = -1742416708
G == 27: p = 988903980
G == 28: p = -398160053
G == 29: p = -770147843
G == 29: @stop

-- trace --
1 avg -0x1.916c3fcp+27
1 max -0x1.916c3fcp+27
1 median -0x1.916c3fcp+27
1 min -0x1.916c3fcp+27
1 range 0x0p+0
2 avg -0x1.0b9b90acp+30
2 max -0x1.916c3fcp+27
2 median -0x1.0b9b90acp+30
2 min -0x1.e509996p+30
2 range 0x1.b2dc1168p+30
3 avg -0x1.5c2a65dp+28
3 max 0x1.121754fcp+30
3 median -0x1.916c3fcp+27
3 min -0x1.e509996p+30
3 range 0x1.7b90772ep+31
4 avg -0x1.2730844p+26
4 max 0x1.121754fcp+30
4 median 0x1.124c46a8p+28
4 min -0x1.e509996p+30
4 range 0x1.7b90772ep+31
5 avg 0x1.386530399999ap+27
5 max 0x1.121754fcp+30
5 median 0x1.76a75698p+29
5 min -0x1.e509996p+30
5 range 0x1.7b90772ep+31
6 avg 0x1.f40b320cccccdp+28
6 max 0x1.7ba13874p+30
6 median 0x1.0d0b5f34p+30
6 min -0x1.e509996p+30
6 range 0x1.b05568eap+31
7 avg 0x1.33734d28ccccdp+30
7 max 0x1.ab28e9dcp+30
7 median 0x1.121754fcp+30
7 min 0x1.76a75698p+29
7 range 0x1.dfaa7d2p+29
8 avg 0x1.7a98cac19999ap+29
8 max 0x1.ab28e9dcp+30
8 median 0x1.0d0b5f34p+30
8 min -0x1.3cab31ecp+30
8 range 0x1.73ea0de4p+31
9 avg 0x1.9e02700333333p+29
9 max 0x1.ab28e9dcp+30
9 median 0x1.13dbc87p+30
9 min -0x1.3cab31ecp+30
9 range 0x1.73ea0de4p+31
10 avg 0x1.bdc49ef19999ap+29
10 max 0x1.ab28e9dcp+30
10 median 0x1.5c70d488p+30
10 min -0x1.3cab31ecp+30
10 range 0x1.73ea0de4p+31
11 avg 0x1.512bb87b33333p+29
11 max 0x1.ab28e9dcp+30
11 median 0x1.13dbc87p+30
11 min -0x1.3cab31ecp+30
11 range 0x1.73ea0de4p+31
12 avg 0x1.3dec1b6p+27
12 max 0x1.5c70d488p+30
12 median 0x1.b08be13p+28
12 min -0x1.3cab31ecp+30
12 range 0x1.4c8e033ap+31
13 avg 0x1.c53b16a333333p+28
13 max 0x1.5c70d488p+30
13 median 0x1.b08be13p+28
13 min -0x1.b221a478p+29
13 range 0x1.1ac0d362p+31
14 avg -0x1.bea18c199999ap+26
14 max 0x1.5c70d488p+30
14 median 0x1.9958ca2p+27
14 min -0x1.ae408fa4p+30
14 range 0x1.8558b216p+31
15 avg -0x1.52648fep+29
15 max 0x1.b08be13p+28
15 median -0x1.b221a478p+29
15 min -0x1.ae408fa4p+30
15 range 0x1.0d31c3f8p+31
16 avg -0x1.53f1bf1e66666p+29
16 max 0x1.a10808cp+28
16 median -0x1.b221a478p+29
16 min -0x1.ae408fa4p+30
16 range 0x1.0b4148eap+31
17 avg -0x1.0643d1399999ap+29
17 max 0x1.a10808cp+28
17 median -0x1.6ddff8p+26
17 min -0x1.ae408fa4p+30
17 range 0x1.0b4148eap+31
18 avg -0x1.bce3bc4cccccdp+27
18 max 0x1.acc64ea4p+30
18 median -0x1.6ddff8p+26
18 min -0x1.ae408fa4p+30
18 range 0x1.ad836f24p+31
19 avg 0x1.300d6d799999ap+27
19 max 0x1.acc64ea4p+30
19 median 0x1.2eb153cp+27
19 min -0x1.65f8176p+30
19 range 0x1.895f3302p+31
20 avg 0x1.514149a666666p+27
20 max 0x1.acc64ea4p+30
20 median 0x1.2eb153cp+27
20 min -0x1.5137adc4p+30
20 range 0x1.7efefe34p+31
21 avg 0x1.5da7e21333333p+28
21 max 0x1.acc64ea4p+30
21 median 0x1.2eb153cp+27
21 min -0x1.5137adc4p+30
21 range 0x1.7efefe34p+31
22 avg 0x1.24e8884p+27
22 max 0x1.acc64ea4p+30
22 median 0x1.2eb153cp+27
22 min -0x1.5137adc4p+30
22 range 0x1.7efefe34p+31
23 avg -0x1.6cc85f7p+28
23 max 0x1.4a8b0ecp+30
23 median -0x1.a48afbap+29
23 min -0x1.5137adc4p+30
23 range 0x1.4de15e42p+31
24 avg -0x1.6cc44f599999ap+28
24 max 0x1.4a8b0ecp+30
24 median -0x1.a48afbap+29
24 min -0x1.5137adc4p+30
24 range 0x1.4de15e42p+31
25 avg -0x1.44ad2e1666666p+28
25 max 0x1.4a8b0ecp+30
25 median -0x1.a48afbap+29
25 min -0x1.1f1ac43p+30
25 range 0x1.34d2e978p+31
26 avg -0x1.ffc515c333333p+28
26 max 0x1.82b4b4ap+28
26 median -0x1.a48afbap+29
26 min -0x1.1f1ac43p+30
26 range 0x1.7fc7f158p+30
27 avg -0x1.374e9aee66666p+29
27 max 0x1.82b4b4ap+28
27 median -0x1.a48afbap+29
27 min -0x1.9f6cad1p+30
27 range 0x1.000ced1cp+31
28 avg -0x1.09c74a4333333p+28
28 max 0x1.d78bd16p+29
28 median 0x1.2ed9f4ap+27
28 min -0x1.9f6cad1p+30
28 range 0x1.45994aep+31
29 avg -0x1.7401b1c99999ap+28
29 max 0x1.d78bd16p+29
29 median -0x1.7bb70b5p+28
29 min -0x1.9f6cad1p+30
29 range 0x1.45994aep+31
30 avg -0x1.21378e799999ap+28
30 max 0x1.d78bd16p+29
30 median -0x1.7bb70b5p+28
30 min -0x1.9f6cad1p+30
30 range 0x1.45994aep+31
