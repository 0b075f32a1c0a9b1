spec 7.20  The largest less the smallest.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 range
F64 p

[Run]
.step
    range = roll_range(p, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 3
G == 1: p = -1
G == 2: p = 0.1
G == 3: p = 0.7
G == 4: p = 0.1
G == 5: p = 0.1
G == 6: p = 0.1
G == 7: p = 1e+16
G == 8: p = 1
G == 9: p = -1e+308
G == 10: p = 1.7e+308
G == 10: @stop

-- trace --
1 range 0x0p+0
2 range 0x1p+2
3 range 0x1p+2
4 range 0x1.b333333333333p+0
5 range 0x1.3333333333333p-1
6 range 0x1.3333333333333p-1
7 range 0x0p+0
8 range 0x1.1c37937e08p+53
9 range 0x1.1c37937e08p+53
10 range 0x1.1ccf385ebc8ap+1023
11 range inf
