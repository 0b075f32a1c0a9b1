spec 2.3  G = T = 9007199254740993 in step 4 is half-way between two F64 values and is read as the even one, 9007199254740992.

-- app.sm --
[state_vector]
U64 G
U32 S
U64 copy
F64 x

[Run]
.step
    copy = G
    x = T

-- app.ss --
[options]
delta_t 3002399751580331

[all_states]
G == 9007199254740992: @stop

-- trace --
4 G 9007199254740993
4 T 9007199254740993
4 copy 9007199254740992
4 x 0x1p+53
