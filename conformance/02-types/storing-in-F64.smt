spec 2.21  Storing in an F64 changes no bit.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 r
F64 x

[Run]
.step
    r = x

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: x = 0.1
G == 1: x = -0.0
G == 2: x = 5e-324
G == 3: x = 1.7976931348623157e+308
G == 4: x = 1/0
G == 5: x = -1/0
G == 6: x = 2.225073858507201e-308
G == 7: x = 9007199254740992.0
G == 8: x = 0.3333333333333333
G == 8: @stop

-- trace --
1 r 0x1.999999999999ap-4
2 r -0x0p+0
3 r 0x0.0000000000001p-1022
4 r 0x1.fffffffffffffp+1023
5 r inf
6 r -inf
7 r 0x0.fffffffffffffp-1022
8 r 0x1p+53
9 r 0x1.5555555555555p-2
