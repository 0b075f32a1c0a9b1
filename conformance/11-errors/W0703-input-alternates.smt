spec 8.15   A script's prev(x) is the value of x two steps ago, so x = prev(x) alternates.
analyses on

-- app.sm --
[state_vector]
U64 time @alias G
U32 S
F64 x @read_only
F64 y @read_only
F64 z @read_only
bool go
[Hold] @safe
.step
    go and x + y + z > 1000: -> Rest
[Rest] @safe
-- app.ss --
[options]
delta_t 10
[local]
F64 frozen = 0
[all_states]
G < 50: x = G / 10
after 50: x = prev(x)              #! W0703 'x' alternates between two values here
from 50 to 90: y = prev(y)         #! W0703 'y' alternates
true { x > 100: z = prev(z) }
true { after 60 { z = prev(z) } }  #! W0703 'z' alternates
at 50: x = prev(x)
at 60: frozen = x
every 20: x = prev(x)
go: x = prev(x)
after 60: y = prev(x)
after 60: y = prev(y) + 1
after 60: y = frozen
at 50: @assert x == 4 or x == 3
at 90: @stop
