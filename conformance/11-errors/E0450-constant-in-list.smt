spec 3.46   A constant among the values of median or average is meant as the size of a window.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 q @read_only
F64 x
[local]
U8 n = 5 @read_only
U8 pLimit = 5 @parameter @range 1 9
[options]
step 10 ms
[define]
size = 3
[Idle]
.step
    x = median(p, 5)                #! E0450 write roll_median(p, 5)
    x = average(p, n)               #! E0450 write roll_avg(p, n)
    x = average(p, 5 steps)         #! E0450 write roll_avg(p, 5 steps)
    x = median(p, 100 ms)           #! E0450 write roll_median(p, 100 ms)
    x = median(p, size)             #! E0450 write roll_median(p, size)
    x = median(p, q, max(n, 3))     #! E0450 write roll_median(p, max(n, 3))
    x = median(p, pLimit)           # the middle of two values
    x = median(p, 0.5)              #! E0450 write roll_median(p, n)
    x = average(7, p)               #! E0450 write roll_avg(7, n)
    x = median(p, q, missing)       #! E0204 missing
