spec 8.49  A call has one value in a step, however often it is evaluated, and all uses of a definition see it.

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
[define]
u = random(0, 1)
[all_states]
true {
    p = u
    @assert u == p and u == n
    @assert 0 <= u < 1
}
true: n = u
p == u: @assert u == p and u == u
at 10: @assert u != prev(u)
at 20: @assert prev(u) != u
at 500: @stop
