spec 1.39  Fractions of a unit beside T and G, and times in products.
warn

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 v

[options]
step 20 ms

[define]
short = 2.5 ms
time  = T

[Run]
.step
    T > 2.5 ms: x = 1            #! W0422 2.5 ms is 2.5 ms, and 'T' is always a whole number of them
    3 ms < T < 500 us: x = 2     #! W0422
    G == 0.1 ms: x = 3           #! W0422
    T > short: x = 4             #! W0422 'short' is 2.5 ms, and 'T' is always a whole number of them
    (T) >= (2.5 ms): x = 5       #! W0422 2.5 ms is 2.5 ms
    time > -short: x = 6         #! W0422 'short' is 2.5 ms, and 'T' is always
    v > short: x = 7
    x = x + v * 20 ms            #! W0423 20 ms is the number 20 in a product or quotient
    x = v * -20 ms               #! W0423 20 ms is the number 20
    x = x / 1 s                  #! W0423 in seconds it is 1
    x = v * (x - 20 ms)
    T > 1.5 s: -> Done

[Done]
