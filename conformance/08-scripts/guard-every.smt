spec 8.39  `every d` is true in the steps whose G is a multiple of d, 0 included.

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
every 30 ms: n = n + 1
every 10: p = p + 1
at 0: @assert n == 1 and p == 1
at 20: @assert n == 1 and p == 3
at 30: @assert n == 2
at 59 s: @stop
at 100 {
    @assert n == 4 and p == 11
    @stop
}
