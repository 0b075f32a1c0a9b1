# Behind the mark: variables and calls by name, both sides of a comparison, each once; numbers with as many digits as matter.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F32 q
U8 n
[Idle]
.step
    p = 0.1 + 0.2
    n = 7
-- app.ss --
[options]
delta_t 5
[Idle]
true: @assert max(p, 1) + n == p + 8 or roll_max(q, 3) > 250  #! E0750 p = 0.30000000000000004, max(p, 1) = 1, n = 7, max(p, 1) + n = 8, p + 8 = 8.3, roll_max(q, 3) = 0
true: @stop
