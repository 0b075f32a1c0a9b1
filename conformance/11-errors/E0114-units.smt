spec 1.16, 1.36, 1.38   Units of time after numbers.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    T > 5s: x = 1           #! E0114 did you mean '5 s'?
    T > 2.5sec: x = 1       #! E0114 did you mean '2.5 s'?
    T > 5 sec: x = 1        #! E0330 did you mean '5 s'?
    T > 1_500msec: x = 1    #! E0114 did you mean '1_500 ms'?
    T > 20 usec: x = 1      #! E0330 did you mean '20 us'?
    T > 2 minutes: x = 1    #! E0330 did you mean '2 min'?
    T > 1.5h: x = 1         #! E0114 did you mean '1.5 h'?
    T > 1e30 seconds: x = 1 #! E0330 did you mean '1e30 s'?
    x = 5 ms
