spec 3.28  clamp limits a value to the range between two others.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  x
F64  lo
F64  hi
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  r7
F64  r8
F64  r9
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7
F64  c8
F64  c9

[local]
F64  kx = 5 @read_only
F64  klo = 2 @read_only
F64  khi = 8 @read_only

[Run]
.step
    r1 = clamp(x, lo, hi)
    r2 = clamp(x - 10, lo, hi)
    r3 = clamp(x + 10, lo, hi)
    r4 = clamp(lo, lo, hi)
    r5 = clamp(hi, lo, hi)
    r6 = clamp(x, hi, lo)
    r7 = clamp(x + 10, hi, lo)
    r8 = clamp(1/0, lo, hi)
    r9 = clamp(x, 6, 6)
    c1 = clamp(kx, klo, khi)
    c2 = clamp(kx - 10, klo, khi)
    c3 = clamp(kx + 10, klo, khi)
    c4 = clamp(klo, klo, khi)
    c5 = clamp(khi, klo, khi)
    c6 = clamp(kx, khi, klo)
    c7 = clamp(kx + 10, khi, klo)
    c8 = clamp(1/0, klo, khi)
    c9 = clamp(kx, 6, 6)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 5
    lo = 2
    hi = 8
    @assert r1 == 5
    @assert r2 == 2
    @assert r3 == 8
    @assert r4 == 2
    @assert r5 == 8
    @assert r6 == 2
    @assert r7 == 2
    @assert r8 == 8
    @assert r9 == 6
    @assert c1 == 5
    @assert c2 == 2
    @assert c3 == 8
    @assert c4 == 2
    @assert c5 == 8
    @assert c6 == 2
    @assert c7 == 2
    @assert c8 == 8
    @assert c9 == 6
    @stop
}
