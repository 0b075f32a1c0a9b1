spec 8.39  Multiples are exact for every G of 64 bits.

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
delta_t 4611686018427387904
[all_states]
every 9223372036854775808: n = n + 1
at 4611686018427387904: @assert n == 1
at 9223372036854775808: @assert n == 2
at 9223372036854775808: @stop
