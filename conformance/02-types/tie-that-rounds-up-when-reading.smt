spec 2.3  Of two equally near F64 values the one with the even last bit may be the larger: 9007199254740995 is read as 9007199254740996.

-- app.sm --
[state_vector]
U64 G
U32 S
U64 copy
F64 x

[Run]
.step
    copy = T
    x = G - 9007199254740994

-- app.ss --
[options]
delta_t 1801439850948199

[all_states]
G >= 9007199254740992: @stop

-- trace --
6 G 9007199254740995
6 T 9007199254740995
6 copy 9007199254740996
6 x 0x1p+1
