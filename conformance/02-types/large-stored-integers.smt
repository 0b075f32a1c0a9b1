spec 2.3, 2.16  A 64-bit integer that the machine has stored is compared as the F64 that it reads as, and so is one that other code has set.

-- app.sm --
[state_vector]
U64 G
U32 S
I64 in
U64 uin
bool below
bool not_below
bool least
bool same
bool mixed
I64 highest
I64 lowest
I64 kept
U64 other

[local]
I64 p = 0
I64 k = 0
I64 odd = 9007199254740993
U64 u = 0

[Run]
.step
    k = 9007199254740992
    below = k < in
    not_below = k < odd
    p = -9223372036854775808
    least = abs(p) > 9223372036854775807
    k = 9223372036854775807
    same = abs(p) == k
    highest = max(k, p)
    lowest = min(abs(p), k)
    u = k
    mixed = u == k
    kept = odd
    other = uin

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    in = 9007199254740993
    uin = 18446744073709551615
    @assert least == false
    @stop
}

-- trace --
1 below false
1 highest 9223372036854775807
1 kept 9007199254740992
1 least false
1 lowest 9223372036854775807
1 mixed true
1 not_below false
1 other 18446744073709551615
1 same true
1 u 9223372036854775808
