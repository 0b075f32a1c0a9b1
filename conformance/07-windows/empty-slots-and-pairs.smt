spec 7.13, 7.12  While a window of 8 fills up, a sample whose neighbour is missing passes on.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 p

[Run]
.step
    avg = roll_avg(p, 8)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1e+16
G == 1: p = 1
G == 2: p = -1e+16
G == 3: p = 1
G == 4: p = 0.1
G == 5: p = 0.2
G == 6: p = 0.3
G == 7: p = 1e+16
G == 8: p = 3
G == 9: p = -1e+16
G == 9: @stop

-- trace --
1 avg 0x1.1c37937e08p+53
2 avg 0x1.1c37937e08p+52
3 avg 0x0p+0
4 avg 0x0p+0
5 avg 0x1.47ae147ae147bp-6
6 avg 0x1.999999999999bp-5
7 avg 0x1.5f15f15f15f17p-4
8 avg 0x1.1c37937e08p+50
9 avg 0x1p-1
10 avg -0x1.1c37937e07ffep+50
