spec 1.37, 5.57  Where G counts seconds, 1500 ms are 1.5.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x1
F64 x2
F64 x3

[options]
time_unit s
step 2 s

[Run]
.step
    x1 = 1500 ms
    x2 = 3 h
    x3 = 2 us
    T >= 0.1 min: -> Done

[Done]

-- app.ss --
[all_states]
T < 0.1 min and S == 1 {
    @assert x1 == 1.5
    @assert x2 == 10800
    @assert x3 == 0.000002
}
G == 6 s: @assert S == 1
G == 8 s: @assert S == 2
G == 8 s: @stop
