spec 8.40  The numbers of a guard by time can have units.

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
at 20000 us: p = 1
from 0.001 min to 1 h: n = n + 1
at 0.05 s: @assert p == 1 and n == 0
at 70: @assert n == 2
at 70: @stop
