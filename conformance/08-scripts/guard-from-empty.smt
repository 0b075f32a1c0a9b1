spec 8.42  A warning says that no step is in a range.
warn no-unused-element

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
from 12 to 18: p = 1       #! W0757 no step is in 'from 12 to 18': G advances by 10 ms
from 30 to 30: p = 1       #! W0757
from 30 to 20: p = 1       #! W0757
from 11 to 20: p = 1       #! W0757
from 10 to 11: p = 1
from 19 to 21: p = 1
at 40: @assert x == 1001
at 40: @stop
