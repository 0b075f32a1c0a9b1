spec 7.22  Windows whose statistics can never be used change nothing for the others.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
F64 r

[Run]
.step
    if false: r = roll_max(p, 5) + roll_min(G, 9)
    q = roll_avg(p, 3)
    if 1 < 0: r = roll_median(q, 7)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = p + 3
G == 4: @assert q == 12
G == 4: @assert r == 0
G == 4: @stop
