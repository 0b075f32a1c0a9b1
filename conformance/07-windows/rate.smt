spec 7.30, 7.34  rate(x, n) is the change over the last n samples, per second.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
F64 b
F64 c
[options]
step 20 ms
[Run]
.step
    a = rate(p, 2 steps)
    b = rate(p, 3)
    c = rate(p + 1, 40 ms)

-- app.ss --
[all_states]
true: p = G * G
G == 0: @assert a == 0 and b == 0 and c == 0
G == 20: @assert a == 400 / 0.02 and b == a
G == 40: @assert a == 1200 / 0.02 and b == 1600 / 0.04 and c == b
G == 100: @assert b == (10000 - 3600) / 0.04 and c == b
G == 100: @stop
