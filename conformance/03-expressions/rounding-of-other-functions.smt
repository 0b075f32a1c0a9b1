spec 3.20, 3.21, 3.22, 3.23  Only whole numbers are unchanged: a root, a quotient and an abs are rounded.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  x
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  r7
F64  r8

[Run]
.step
    r1 = floor(sqrt(x))
    r2 = ceil(sqrt(x))
    r3 = trunc(sqrt(x))
    r4 = round(sqrt(x))
    r5 = floor(abs(x))
    r6 = ceil(min(x, 100))
    r7 = trunc(x / 2)
    r8 = floor(round(x))

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 6.5
    @assert r1 == 2
    @assert r2 == 3
    @assert r3 == 2
    @assert r4 == 3
    @assert r5 == 6
    @assert r6 == 7
    @assert r7 == 3
    @assert r8 == 7
    @stop
}
