# The trace: one line an element and step, in the report's order and under its names; F32 and F64 as %a has them.

-- app.sm --
[state_vector]
U64 time @alias G
U32 S
F64 x @alias a
F32 y
I8 n
bool b
[Only]
.step
    y = x
    n = n - 1
    b = x
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: x = 1/3
G == 10: x = -0.0
G == 20: x = 5e-324
G == 30: x = 1e300
G == 40: x = 1024
G == 50: x = 2.2250738585072009e-308
G == 60: x = 0.1
G == 60: @stop
-- trace --
1 G 0
1 S 1
1 T 0
1 a 0x1.5555555555555p-2
1 b true
1 n -1
1 y 0x1.555556p-2
2 G 10
2 T 10
2 a -0x0p+0
2 b false
2 n -2
2 y -0x0p+0
3 a 0x0.0000000000001p-1022
3 b true
3 y 0x0p+0
4 a 0x1.7e43c8800759cp+996
4 y inf
5 a 0x1p+10
5 n -5
5 y 0x1p+10
6 a 0x0.fffffffffffffp-1022
7 a 0x1.999999999999ap-4
7 n -7
7 y 0x1.99999ap-4
