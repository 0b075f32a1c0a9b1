spec 8.18  An assert reads the values after the step, while G, S and T are still those of the step.

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
G == 0 {
    @assert x == 99 and S == 1 and G == 0 and T == 0
    p = 99
}
G == 1: @stop
