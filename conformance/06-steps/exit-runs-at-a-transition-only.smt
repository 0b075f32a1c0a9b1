spec 6.9  .exit runs in the step of a transition, after .step, and in no other.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step
    x = x * 10 + 1
    G == 2: -> B
.exit
    x = x * 10 + 2

[B]
.step
    x = x * 10 + 3
.exit
    x = x * 10 + 4

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 1
G == 1: @assert x == 11
G == 2: @assert x == 1112
G == 3: @assert x == 11123
G == 4: @assert x == 111233
G == 4: @stop
