spec 8.39  `after a` is true from a on.

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
after 30 ms: n = n + 1
after 15: p = p + 1
at 20: @assert n == 0 and p == 1
at 30: @assert n == 1 and p == 2
after 60 {
    @assert n == 4 and p == 5
    @stop
}
