spec 6.14  .entry is seen by .step, .step by .exit, .exit by the next step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[local]
F64 k = 1

[A]
.entry
    k = k + 1
.step
    k = k * 10
    -> B
.exit
    k = k + 5
    x = k
[B]
.entry
    y = k

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 25 and y == 0
G == 1: @assert y == 25
G == 1: @stop
