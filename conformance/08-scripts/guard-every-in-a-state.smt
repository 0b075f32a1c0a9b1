spec 8.39, 8.40  A state's section counts G, which goes on from state to state.

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
[Burn]
every 20: n = n + 1
T == 0: @assert G == 40 and n == 1
after 100 {
    @assert T == 60 and n == 4
    @stop
}
