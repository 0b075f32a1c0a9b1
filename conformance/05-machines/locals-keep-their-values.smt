spec 5.12  A local keeps its value through steps and transitions, back into the first state too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
U32 n = 10

[A]
.step
    n = n + 1
    -> B

[B]
.step
    n = n * 2
    x = n
    T == 1: -> A

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert n == 11
G == 1: @assert n == 22
G == 2: @assert n == 44
G == 3: @assert n == 45
G == 4: @assert n == 90 and x == 90
G == 4: @stop
