spec 3.17   A function of another language is not assumed to be the one with the nearest name.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
[Idle]
.step
    x = sinh(p)                     #! E0217 outside the machine
    x = cosh(p) + tanh(p)           #! E0217 outside the machine #! E0217 outside the machine
    x = random()                    #! E0766 a machine has no random numbers
    x = ln(p) + log2(p)             #! E0217 write log(x) #! E0217 write log(x) / log(2)
    x = sind(p)                     #! E0217 write sin(x * 0.017453292519943295)
    x = deg2rad(p) + degrees(p)     #! E0217 write x * 0.017453292519943295 #! E0217 write x * 57.29577951308232
    x = moving_avg(p, 5)            #! E0217 write roll_avg(x, n)
    x = med(p, x, 1)                #! E0217 median(a, b, c) for several values
    x = delta(p)                    #! E0217 write x - prev(x)
    changed(p): x = 1               #! E0217 write x != prev(x)
    stable(p > 5, 20 ms): x = 1     #! E0217 held(x > 5, 500 ms)
    x = sqr(p)                      #! E0217 multiply
    x = mean(p, 5)                  #! E0217 write roll_avg(x, n)
    x = constrain(p, 0, 1)          #! E0217 write clamp(x, lo, hi)
    x = power(p, 2)                 #! E0217 write pow(x, y)
    x = flor(p)                     #! E0217 did you mean 'floor'?
    x = 2 * PI                      #! E0204 F64 pi = 3.141592653589793 @read_only
