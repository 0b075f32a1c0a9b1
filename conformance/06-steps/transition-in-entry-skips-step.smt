spec 6.8  After a transition in .entry .step does not run, but .exit does.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.entry
    x = x + 1
    -> B
.step
    x = x + 10
.exit
    x = x + 100

[B]
.step
    x = x + 1000

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 101 and S == 1
G == 1: @assert x == 1101 and S == 2
G == 1: @stop
