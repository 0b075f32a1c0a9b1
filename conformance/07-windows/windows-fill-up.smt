spec 7.7  Statistics of a window that is not full yet are over the samples present.

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
    avg = roll_avg(p, 8)
    median = roll_median(p, 8)
    min = roll_min(p, 8)
    max = roll_max(p, 8)
    range = roll_range(p, 8)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 3
G == 1: p = 1
G == 2: p = 4
G == 3: p = 1.5
G == 4: p = 9
G == 5: p = 2
G == 5: @stop

-- trace --
1 avg 0x1.8p+1
1 max 0x1.8p+1
1 median 0x1.8p+1
1 min 0x1.8p+1
1 range 0x0p+0
2 avg 0x1p+1
2 max 0x1.8p+1
2 median 0x1p+1
2 min 0x1p+0
2 range 0x1p+1
3 avg 0x1.5555555555555p+1
3 max 0x1p+2
3 median 0x1.8p+1
3 min 0x1p+0
3 range 0x1.8p+1
4 avg 0x1.3p+1
4 max 0x1p+2
4 median 0x1.2p+1
4 min 0x1p+0
4 range 0x1.8p+1
5 avg 0x1.d99999999999ap+1
5 max 0x1.2p+3
5 median 0x1.8p+1
5 min 0x1p+0
5 range 0x1p+3
6 avg 0x1.b555555555555p+1
6 max 0x1.2p+3
6 median 0x1.4p+1
6 min 0x1p+0
6 range 0x1p+3
