spec 8.17, 8.18  A guard that was true before the step counts, even if the machine has changed its variables; one that was false does not become true after the step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 ro @read_only @alias q

[local]
F64 k = 5
F64 c = 7 @read_only

[A]
.step
    x = p
    p == 99: -> B

[B]
.step
    x = p + 1000

-- app.ss --
[options]
delta_t 1

[all_states]
x == 0: @assert x == 7
x == 7: @assert false
G == 0: p = 7
G == 0: @stop
