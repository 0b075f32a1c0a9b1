spec 8.39  `at a` is true in the step with that G alone, also in a state's section.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 n
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- app.ss --
[options]
delta_t 10
[all_states]
at 0: p = 1
at 20: p = 2
if at 50 ms { p = 5 }
at 0: @assert x == 1
G == 10: @assert x == 1
G == 20: @assert x == 2
G == 30: @assert x == 2
G == 50: @assert x == 1005
at 0.1 s {
    @assert n == 1
    @stop
}
[Burn]
at 50: n = n + 1
at 10: n = n + 100
