spec 5.12, 6.14, 2.16  A machine that counts, toggles and saturates over a hundred steps.

-- app.sm --
[state_vector]
U64 G
U32 S
bool led
U8 duty
F64 total

[local]
U8 n = 0
bool up = true
I16 level = -3

[Run]
.step
    n = n + 1
    if up: level = level + n * 0.5
    else: level = level - n
    level > 500 or level < -500: up = not up
    led = n / 2 == floor(n / 2)
    duty = level
    total = total + duty
    n == 120: -> Run
.exit
    n = 7

-- app.ss --
[options]
delta_t 1

[all_states]
G == 300: @stop

-- trace --
1 duty 0
1 led false
1 level -2
1 n 1
2 duty 0
2 led true
2 level -1
2 n 2
3 duty 0
3 led false
3 level 0
3 n 3
51 duty 213
51 led false
51 level 213
51 n 51
120 duty 0
120 led true
120 level -1843
120 n 7
121 duty 0
121 led true
121 level -1839
121 n 8
122 duty 0
122 led false
122 level -1848
122 n 9
201 duty 0
201 led true
201 level -2779
201 n 88
301 duty 0
301 led false
301 level -4266
301 n 75
301 total 0x1.ef1p+12
