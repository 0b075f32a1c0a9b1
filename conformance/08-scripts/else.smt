spec 8.46  An else runs when its guard was false, a chain ends at the first true guard.

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
else: p = 2
p == 1: n = 1
else if at 10 ms: n = 2
else if from 20 to 40 {
    n = 3
} else {
    n = 4
}
at 0: @assert x == 1 and n == 1
at 10: @assert x == 2 and n == 2
at 20: @assert n == 3
at 30: @assert n == 3
at 40: @assert n == 4
at 50: @stop
[A]
T > 20: @assert x == 2
else {
    @assert T <= 20
}
