spec 8.42, 8.51, 8.52  `noise` is sigma times the sum of twelve numbers.

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
true: p = noise(2)
at 0: @assert x == 2 * (17737771401 / 4294967296 - 6)
at 10: @assert x == 2 * (30744991474 / 4294967296 - 6)
at 20: @stop
