spec 3.31  A variable of the same name counts.
warn

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 Run = 7
[define]
Done = 2
[Run]
.step
    S == Run: x = 1          #! W0424 'Run' is the variable here
    S == Done: x = 2         #! W0424
    Run = 8
    x > 50: -> Done
[Done]
.step
    S == Done: x = 3         #! W0424

-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: @assert x == 0
G == 1: x = 51
G == 2: @assert x == 3
G == 2: @stop
