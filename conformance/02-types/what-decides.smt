spec 2.22, 2.13  A guard is true for everything but zeros and NaN.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 r
F64 x
F64 nan

[Run]
.step
    r = 0
    if nan {
        x / x { r = 1 }
    }
    else: x { r = 1 }

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: x = 0
G == 1: x = -0.0
G == 2: x = 1
G == 3: x = 0.5
G == 4: x = -3
G == 5: x = 256
G == 6: x = 65536
G == 7: x = 4294967296
G == 8: x = 1e+300
G == 9: x = 1e-300
G == 10: x = 5e-324
G == 11: x = 1/0
G == 12: x = -1/0
G == 13: x = 0
G == 13: nan = 1
G == 13: @stop

-- trace --
1 r 0x0p+0
2 r 0x0p+0
3 r 0x1p+0
4 r 0x1p+0
5 r 0x1p+0
6 r 0x1p+0
7 r 0x1p+0
8 r 0x1p+0
9 r 0x1p+0
10 r 0x1p+0
11 r 0x1p+0
12 r 0x1p+0
13 r 0x1p+0
14 r 0x0p+0
