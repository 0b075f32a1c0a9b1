spec 5.68, 5.69, 5.71  Statements for all states run before those of the state, in file order.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 n

[all_states] @except Last
.step
    x = 1
    y = x
    p == 7: -> Last

[Run]
.entry
    x = 10
    n = n + 1
.step
    x = x + 1
    T > 2: -> Wait

[Wait]

[Last]
.step
    x = x + 5
    y == 99: x = 0

[all_states]
.step
    y = y + 2 * x

-- app.ss --
[options]
delta_t 1

[Run]
T == 0: @assert x == 2 and y == 3 and n == 1
T == 1: @assert x == 2 and y == 3
[Wait]
T == 0: @assert x == 1 and y == 3
T == 5: p = 7
T == 5: @assert x == 1 and y == 1
[Last]
T == 0: @assert x == 6 and y == 3
T == 1: @assert x == 11 and y == 15
T == 1: @assert S == 3   #! W0752
T == 1: @stop
