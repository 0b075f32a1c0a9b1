spec 2.6  Products and sums of whole numbers beyond 2^53 are rounded as F64, and do not wrap around.

-- app.sm --
[state_vector]
U64 G
U32 S
U32  u
I32  i
U16  h
I64  l
U64  w
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  r7
F64  r8
F64  r9
F64  r10
F64  r11
F64  r12
F64  r13
F64  r14
F64  r15
F64  r16
F64  r17
F64  r18
F64  r19
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7
F64  c8
F64  c9
F64  c10
F64  c11
F64  c12
F64  c13
F64  c14
F64  c15
F64  c16
F64  c17
F64  c18
F64  c19

[local]
U32  ku = 4294967295 @read_only
I32  ki = -2147483648 @read_only
U16  kh = 65535 @read_only
I64  kl = 9007199254740992 @read_only
U64  kw = 18446744073709549568 @read_only

[Run]
.step
    r1 = u * u
    r2 = i * i
    r3 = u * u * u
    r4 = i * u
    r5 = h * h * h * h * h
    r6 = u * u + 1
    r7 = u * u - u * u + h
    r8 = l + 1
    r9 = l + 1 + 1
    r10 = l + h
    r11 = w + w
    r12 = w - u
    r13 = i - u
    r14 = -i
    r15 = abs(i)
    r16 = i * -1
    r17 = i - 1
    r18 = u + 1
    r19 = h * u + i
    c1 = ku * ku
    c2 = ki * ki
    c3 = ku * ku * ku
    c4 = ki * ku
    c5 = kh * kh * kh * kh * kh
    c6 = ku * ku + 1
    c7 = ku * ku - ku * ku + kh
    c8 = kl + 1
    c9 = kl + 1 + 1
    c10 = kl + kh
    c11 = kw + kw
    c12 = kw - ku
    c13 = ki - ku
    c14 = -ki
    c15 = abs(ki)
    c16 = ki * -1
    c17 = ki - 1
    c18 = ku + 1
    c19 = kh * ku + ki

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    u = 4294967295
    i = -2147483648
    h = 65535
    l = 9007199254740992
    w = 18446744073709549568
    @assert r1 == 1.8446744065119617e+19
    @assert r2 == 4.611686018427388e+18
    @assert r3 == 7.9228162458924105e+28
    @assert r4 == -9.223372034707292e+18
    @assert r5 == 1.2088335887089674e+24
    @assert r6 == 1.8446744065119617e+19
    @assert r7 == 65535
    @assert r8 == 9007199254740992.0
    @assert r9 == 9007199254740992.0
    @assert r10 == 9007199254806528.0
    @assert r11 == 3.68934881474191e+19
    @assert r12 == 1.8446744069414582e+19
    @assert r13 == -6442450943
    @assert r14 == 2147483648
    @assert r15 == 2147483648
    @assert r16 == 2147483648
    @assert r17 == -2147483649
    @assert r18 == 4294967296
    @assert r19 == 281468534194177
    @assert c1 == 1.8446744065119617e+19
    @assert c2 == 4.611686018427388e+18
    @assert c3 == 7.9228162458924105e+28
    @assert c4 == -9.223372034707292e+18
    @assert c5 == 1.2088335887089674e+24
    @assert c6 == 1.8446744065119617e+19
    @assert c7 == 65535
    @assert c8 == 9007199254740992.0
    @assert c9 == 9007199254740992.0
    @assert c10 == 9007199254806528.0
    @assert c11 == 3.68934881474191e+19
    @assert c12 == 1.8446744069414582e+19
    @assert c13 == -6442450943
    @assert c14 == 2147483648
    @assert c15 == 2147483648
    @assert c16 == 2147483648
    @assert c17 == -2147483649
    @assert c18 == 4294967296
    @assert c19 == 281468534194177
    @stop
}
