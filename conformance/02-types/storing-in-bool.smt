spec 2.22  A bool becomes true for everything but zeros and NaN: 256, 1e-300 and infinities too.

-- app.sm --
[state_vector]
U64 G
U32 S
bool r
F64 x
F64 nan

[Run]
.step
    if nan: r = x / x
    else: r = x

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
1 r false
2 r false
3 r true
4 r true
5 r true
6 r true
7 r true
8 r true
9 r true
10 r true
11 r true
12 r true
13 r true
14 r false
