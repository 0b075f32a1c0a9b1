spec 1.37, 1.39, 7.24, 7.30  Where G counts microseconds, 1 s is 1000000. Messages do not shorten it.
warn

-- app.sm --
[options]
time_unit us
step 1 s
[state_vector]
U64 G
U32 S
F64 v @read_only
F64 x
[Run]
.step
    x = v * 2 s                      #! W0423 2 s is the number 2000000 in a product
    x = roll_avg(v, 1500 ms)         #! E0412 1000000 us or 2000000 us would be
    x = held(v > 1, 5000000)         #! E0414 write '5000000 steps', or a time such as '5000000 us'
    T > 1.0000005 s: x = 1           #! W0422 1.0000005 s is 1000000.5 us
    x = roll_avg(v, 2 s) + held(v > 2, 1000000 us)
