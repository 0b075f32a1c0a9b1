spec 8.48  Random numbers have constant arguments, and belong to steps.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 n
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- app.ss --
[options]
delta_t 10
[local]
F64 u = random(0, 1)                     #! E0764 an initial value
F64 v = 1
F64 w = 2 @read_only
[define]
three = 3
[all_states]
true: p = roll_avg(p, random(1, 2))      #! E0764 the size of a window
true: p = noise(x)                       #! E0765 write x * noise(1)
true: p = noise(v)                       #! E0765
true: p = random(0, T)                   #! E0765
true: p = random(0, random(0, 1))        #! E0765
true: p = random(1)                      #! E0401 (lo, hi)
true: p = noise()                        #! E0401 (sigma)
true: p = noise(w * three) + random(-w, 20 ms)
at 0: @expect x > 3 within random(0, 1)  #! E0709
at 10: @stop
