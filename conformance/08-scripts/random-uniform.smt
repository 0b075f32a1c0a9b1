spec 8.42, 8.51, 8.52  `random` has the published numbers of PCG32, in the order of the calls.

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
seed 42
[all_states]
at 0: @assert random(0, 4294967296) == 1307692281
at 0: n = random(-1, 3)
at 0: @assert n == -1 + 4 * (4286966985 / 4294967296)
every 10: p = random(0, 4294967296)
at 0: @assert x == 1594523791
at 10: @assert x == 3573220945
at 20: @stop
