spec 7.11  The sum is divided by the count, not multiplied by its inverse nor the samples divided first.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 avg
F64 p

[Run]
.step
    avg = roll_avg(p, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 49
G == 1: p = 0.1
G == 2: p = 0.1
G == 3: p = 7
G == 4: p = 1
G == 5: p = 1e-320
G == 6: p = 5e-324
G == 7: p = 3
G == 8: p = 9
G == 9: p = 0.7
G == 9: @stop

-- trace --
1 avg 0x1.88p+5
2 avg 0x1.88ccccccccccdp+4
3 avg 0x1.0666666666667p+4
4 avg 0x1.3333333333333p+1
5 avg 0x1.5999999999999p+1
6 avg 0x1.5555555555555p+1
7 avg 0x1.5555555555555p-2
8 avg 0x1p+0
9 avg 0x1p+2
10 avg 0x1.0eeeeeeeeeeefp+2
