spec 8.40  `every 20` in a state's section compares G, also where T is no multiple of 20 then.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 n
[A]
.step
    T == 20: -> Burn
[Burn]
-- app.ss --
[options]
delta_t 10
[Burn]
every 20: n = n + 1
T == 0: @assert G == 30 and n == 0
T == 10: @assert n == 1
after 100 {
    @assert T == 70 and n == 4
    @stop
}
