spec 8.39  `from a to b` is true from a on, and no longer at b.

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
from 20 to 50: n = n + 1
from 0.06 s to 75 ms: n = n + 100
from 61 to 75: n = n + 1000
at 10: @assert n == 0
at 20: @assert n == 1
at 40: @assert n == 3
at 50: @assert n == 3
at 100 {
    @assert n == 1203
    @stop
}
