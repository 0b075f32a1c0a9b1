spec 1.36  A time alone is no condition.
warn

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Run]
.step
    5 s: -> Done       #! W0419 did you mean 'T >= 5 s'?
[Done]

-- app.ss --
[options]
delta_t 10
[all_states]
G == 10: @assert S == Done
2 s: x = 3             #! W0419 did you mean 'G == 2 s'?
G == 30: @stop
