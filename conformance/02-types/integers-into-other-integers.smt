spec 2.15, 2.16, 2.6  Whole numbers calculated from whole numbers, stored in every type.

-- app.sm --
[state_vector]
U64 G
U32 S
I32 n
U8 a
I8 b
U16 c
I16 d
U32 e
I64 f
U64 g
F32 h
bool k

[Run]
.step
    a = n + 1
    b = n - 1
    c = n * 2
    d = -n
    e = n * n
    f = n * n - n
    g = n - 1
    h = n / 3
    k = n + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: n = 0
G == 1: n = 1
G == 2: n = -1
G == 3: n = 100
G == 4: n = -100
G == 5: n = 127
G == 6: n = -128
G == 7: n = 200
G == 8: n = 255
G == 9: n = -32768
G == 10: n = 65535
G == 11: n = 2147483647
G == 12: n = -2147483648
G == 12: @stop

-- trace --
1 a 1
1 b -1
1 c 0
1 d 0
1 e 0
1 f 0
1 g 0
1 h 0x0p+0
1 k true
2 a 2
2 b 0
2 c 2
2 d -1
2 e 1
2 f 0
2 g 0
2 h 0x1.555556p-2
2 k true
3 a 0
3 b -2
3 c 0
3 d 1
3 e 1
3 f 2
3 g 0
3 h -0x1.555556p-2
3 k false
4 a 101
4 b 99
4 c 200
4 d -100
4 e 10000
4 f 9900
4 g 99
4 h 0x1.0aaaaap+5
4 k true
5 a 0
5 b -101
5 c 0
5 d 100
5 e 10000
5 f 10100
5 g 0
5 h -0x1.0aaaaap+5
5 k true
6 a 128
6 b 126
6 c 254
6 d -127
6 e 16129
6 f 16002
6 g 126
6 h 0x1.52aaaap+5
6 k true
7 a 0
7 b -128
7 c 0
7 d 128
7 e 16384
7 f 16512
7 g 0
7 h -0x1.555556p+5
7 k true
8 a 201
8 b 127
8 c 400
8 d -200
8 e 40000
8 f 39800
8 g 199
8 h 0x1.0aaaaap+6
8 k true
9 a 255
9 b 127
9 c 510
9 d -255
9 e 65025
9 f 64770
9 g 254
9 h 0x1.54p+6
9 k true
10 a 0
10 b -128
10 c 0
10 d 32767
10 e 1073741824
10 f 1073774592
10 g 0
10 h -0x1.555556p+13
10 k true
11 a 255
11 b 127
11 c 65535
11 d -32768
11 e 4294836225
11 f 4294770690
11 g 65534
11 h 0x1.5554p+14
11 k true
12 a 255
12 b 127
12 c 65535
12 d -32768
12 e 4294967295
12 f 4611686011984936960
12 g 2147483646
12 h 0x1.555556p+29
12 k true
13 a 0
13 b -128
13 c 0
13 d 32767
13 e 4294967295
13 f 4611686020574871552
13 g 0
13 h -0x1.555556p+29
13 k true
