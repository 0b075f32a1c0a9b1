spec 3.7, 2.8  The order shows in the last bit.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  c
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  r7
F64  r8
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7
F64  c8

[local]
F64  ka = 0.1 @read_only
F64  kb = 0.7 @read_only
F64  kc = 0.3 @read_only

[Run]
.step
    r1 = a + b + c
    r2 = c + b + a
    r3 = a * b * c
    r4 = c * b * a
    r5 = a / b / c
    r6 = a / (b * c)
    r7 = a + b - c
    r8 = b - c + a
    c1 = ka + kb + kc
    c2 = kc + kb + ka
    c3 = ka * kb * kc
    c4 = kc * kb * ka
    c5 = ka / kb / kc
    c6 = ka / (kb * kc)
    c7 = ka + kb - kc
    c8 = kb - kc + ka

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.1
    b = 0.7
    c = 0.3
    @assert r1 == 1.0999999999999999
    @assert r2 == 1.1
    @assert r3 == 0.020999999999999998
    @assert r4 == 0.021
    @assert r5 == 0.4761904761904763
    @assert r6 == 0.4761904761904762
    @assert r7 == 0.49999999999999994
    @assert r8 == 0.5
    @assert c1 == 1.0999999999999999
    @assert c2 == 1.1
    @assert c3 == 0.020999999999999998
    @assert c4 == 0.021
    @assert c5 == 0.4761904761904763
    @assert c6 == 0.4761904761904762
    @assert c7 == 0.49999999999999994
    @assert c8 == 0.5
    @stop
}
