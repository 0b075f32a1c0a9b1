spec 5.42  Statements after a transition in the same block never run, which causes a warning.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step
    if T == 0 {
        x = 1
        -> B
        x = 2   #! W0501
    }
    x = 3

[B]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 1
G == 1: @assert x == 1 and S == 2
G == 1: @stop
