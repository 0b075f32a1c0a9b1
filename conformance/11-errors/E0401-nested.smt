spec 3.17, 3.42   The smallest or largest of more than 16 values needs nested calls.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
[Idle]
.step
    x = max(p, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)  #! E0401 max(max(max(p, 1), 2), 3)
    x = median(p, x, p, x, p, x, p, x, p, x, p, x, p, x, p, x, p)      #! E0401 median takes 2 to 16 arguments, not 17
    x = min(p)                      #! E0401 roll_min(p, n)
    x = average(p)                  #! E0401 roll_avg(p, n)
    x = median()                    #! E0401 write median(a, b, ...)
    x = round(p + 1, 2)             #! E0401 round((p + 1) * 100) / 100
    x = clamp(p, 1)                 #! E0401 write clamp(x, lo, hi)
