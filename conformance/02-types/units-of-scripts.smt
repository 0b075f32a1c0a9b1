spec 2.38  In a script units apply to all expressions.
warn no-all units

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit m
F64 b @unit ft
F64 x

[Run] @safe
.step
    x = a

-- app.ss --
[options]
delta_t 10

[local]
F64 plant = 3 @unit ft
F64 wrong = plant @unit m               #! W0448

[define]
high = 300 @unit ft
late = G + 5 @unit ms
limit = 2 @unit s
low  = a @unit ft                       #! W0448

[all_states]
G == 0: a = plant                       #! W0448
G == 0: a = plant * 0.3048
G == 0: b = high
a > high: b = low                       #! W0448
G == 10: @assert a < b                  #! W0448
G == 10: @assert a < 300
G == 20: @print a + b "sum"             #! W0448
G > 0: x = T > limit                    #! W0448 1 s is 1000 ms
G > 20: a = T - 20
G > 20: b = late                        #! W0448
G == 20: @stop
