spec 8.43  The words of guards by time are names where no number follows on the line.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 at
F64 from
F64 after
F64 every
[A]
.step
    x = from
    at > 0: x = -at
-- app.ss --
[options]
delta_t 10
[local]
bool to = false
[all_states]
at == 0: from = 1
(at
) > 5: from = 2
from > 0 {
    after = from + 1
}
after: every = 4
after - 2 == 0 and G < 20: @assert x == 1 and every == 4
G == 20: at = 6
G == 30: @assert from == 2 and after == 3 and x == -6
(at
) == 6 and G > 20: to = true
to: @stop
