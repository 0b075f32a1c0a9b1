spec 6.12  In .exit, and after it until the next step, S and T are those of the state that is left.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[A]
.step
    T == 4: -> B
.exit
    x = S
    y = T

[B]

-- app.ss --
[options]
delta_t 2

[all_states]
G == 4: @assert x == 1 and y == 4 and S == 1 and T == 4
G == 6: @assert S == 2 and T == 0
G == 6: @stop
