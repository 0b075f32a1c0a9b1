spec 7.30, 7.34  Numbers alone, fractions and impossible sizes are errors.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
[options]
step 20 ms
[define]
n = 20 ms + 1 ms
k = 4
[Run]
.step
    a = held(p > 1, 20)           #! E0414 write '20 steps', or a time such as '20 ms'
    a = held(p > 1, 0.2)          #! E0414 write the time with its unit, as in 0.2 s
    a = held(p > 1, k)            #! E0414 write 'k steps', or a time such as '4 ms'
    a = held(p > 1, k + 1)        #! E0414 write '5 steps', or a time such as '5 ms'
    a = held(p > 1, 0.5 us)       #! E0415
    a = held(p > 1, 0 s)          #! E0415
    a = held(p > 1, 9007199254740992 ms)
    a = held(p > 1, 9007199254740994 ms)      #! E0415
    a = held(p > 1, 0 steps)      #! E0405
    a = held(p > 1, 1.5 steps)    #! E0404
    a = held(p > 1, 100001 steps) #! E0405
    a = held(p > 1, n)            #! E0413
    a = held(p > 1)               #! E0401
    a = held(missing > 1, 1 s)    #! E0204
    a = held(gone > 1, 3)         #! E0204  #! E0414
    a = rate(lost, 40 ms)         #! E0204
    a = prev(none) + rising(no)   #! E0204 none  #! E0204 no
    a = rate(p, 1)                #! E0416
    a = rate(p, 0 ms)             #! E0416
    a = rate(p, 30 ms)            #! E0412
