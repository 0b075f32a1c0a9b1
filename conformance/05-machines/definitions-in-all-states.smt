spec 5.61, 5.69  Definitions, state names and times in rules for all states.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[options]
step 10 ms
[define]
high = p > 5 and S != Abort
[all_states] @except Abort
.step
    high and T >= 30 ms: -> Abort
    S == Run { x = x + 1 } else { x = x + 10 }
[Run]
.step
    T == 20 ms: -> Next
[Next]
[Abort]

-- app.ss --
[Run]
T == 20 ms: p = 6
T == 20 ms: @assert x == 3
[Next]
T == 20 ms: @assert x == 33
[Abort]
T == 0: @assert x == 33
T == 0: @stop
