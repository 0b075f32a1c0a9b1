spec 7.34  With one sample the rate is 0, whatever the sample; infinities have no difference.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
F64 b
bool n
[local]
F64 inf = 1 / 0
[Run]
.step
    a = rate(inf, 2 steps)
    n = rate(inf, 2 steps) == rate(inf, 2 steps)
    b = rate(p * inf, 2 steps)

-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: @assert a == 0 and n and b == 0
G == 1: p = 1
G == 1: @assert a == 0 and not n
G == 1: @stop
