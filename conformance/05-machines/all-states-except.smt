spec 5.70  A section does not run in the states that it excepts.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 n
F64 m

[all_states] @except Abort
.step
    n = n + 1
    p > 3: -> Abort
[all_states] @except Abort Safe
.step
    m = m + 1
    n > 100: -> Safe
[Run]
[Abort]
.step
    T > 2: -> Safe
[Safe]

-- app.ss --
[options]
delta_t 1
[Run]
T == 4: p = 5
T == 4: @assert n == 5 and m == 4
[Abort]
true: p = 0
T == 3: @assert n == 5 and m == 4
[Safe]
T == 3: @assert n == 9 and m == 4
T == 3: @stop
