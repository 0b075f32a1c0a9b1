spec 2.3  G is exact as it is stored; read in an expression it is the nearest F64, the even one of two.

-- app.sm --
[state_vector]
U64 G
U32 S
U64 copy
F64 x
bool odd

[Run]
.step
    copy = G
    x = G - 9007199254740992
    odd = G == 9007199254740992 and G > 0

-- app.ss --
[options]
delta_t 9007199254740991

[all_states]
T >= 1: @stop

-- trace --
1 G 0
2 G 9007199254740991
2 copy 9007199254740991
2 x -0x1p+0
