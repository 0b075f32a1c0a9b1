spec 2.3  An I64 or U64 that no F64 equals is read as the nearest one; half-way cases take the even one. G grows by exact steps and passes odd values.

-- app.sm --
[state_vector]
U64 G
U32 S
U64 copy

[Run]
.step
    copy = G

-- app.ss --
[options]
delta_t 4503599627370497

[all_states]
G > 30000000000000000: @stop

-- trace --
1 copy 0
2 copy 4503599627370497
3 copy 9007199254740994
4 copy 13510798882111492
5 copy 18014398509481988
6 copy 22517998136852484
7 copy 27021597764222984
8 copy 31525197391593480
