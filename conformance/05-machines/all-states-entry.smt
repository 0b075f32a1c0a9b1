spec 5.72  .entry that leaves the state skips the statements.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 n

[all_states] @except Abort
.step                              #! W0518 .entry of 'Check' or 'Again' or 'Last' makes a transition
    n = n + 1
    p > 3: -> Abort
[Run]
.step
    T > 90: -> Last
    T > 0: -> Check
[Check]
.entry
    p > 1: -> Again
[Again]
.entry
    p > 2 {
        n = n + 10
        -> Run
    }
[Last]
.entry
    p > 9: n = 0
    else: -> Run
[Abort]
.entry
    -> Run

-- app.ss --
[options]
delta_t 1
[Run]
T == 1: p = 2
T == 1: @assert n == 2
[Check]
T == 0: @assert n == 2
[Again]
T == 0: @assert n == 3
T == 0: @stop
