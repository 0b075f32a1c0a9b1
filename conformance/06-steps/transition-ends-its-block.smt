spec 6.10  After a transition nothing more of its block runs, in braces and behind them.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[A]
.step
    x = 1
    if G == 1 {
        if true {
            y = 1
            G == 1: -> B
            y = 2
        }
        y = 3
    }
    x = 2
    G == 1: x = 4

[B]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 2 and y == 0
G == 1: @assert x == 1 and y == 1
G == 1: @stop
