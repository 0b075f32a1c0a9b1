spec 8.44  `state Burn` is 1 while the machine is in that state, else 0.

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
[local]
F64 seen = 0
[all_states]
state A: p = 5
state Burn and p == 5: p = 6
every 10: seen = seen + state Burn
at 10: @assert state A and not state Burn
at 30: @assert state A
at 40: @assert state Burn and state A == 0
at 50: n = state Burn * 3
at 50: @assert n == 3 and x == 1006
at 60 {
    @assert (state Burn) + 1 == 2
    @assert seen == 3
    @stop
}
