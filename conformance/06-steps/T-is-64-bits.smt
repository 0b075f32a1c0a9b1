spec 6.5  T can exceed 32 bits.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
U64 n

[Run]
.step
    x = T
    n = T

-- app.ss --
[options]
delta_t 4294967296

[all_states]
G == 12884901888: @assert x == 12884901888 and n == T
G == 12884901888: @stop

-- trace --
1 T 0
2 T 4294967296
3 T 8589934592
4 n 12884901888
