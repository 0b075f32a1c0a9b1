spec 8.13  G grows by delta_t in 64 bits, beyond the precision of an F64.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 ro @read_only @alias q

[local]
F64 k = 5
F64 c = 7 @read_only

[A]
.step
    x = p
    p == 99: -> B

[B]
.step
    x = p + 1000

-- app.ss --
[options]
delta_t 9007199254740991

[all_states]
G > 60000000000000000: @stop

-- trace --
1 G 0
2 G 9007199254740991
3 G 18014398509481982
4 G 27021597764222973
5 G 36028797018963964
6 G 45035996273704955
7 G 54043195528445946
8 G 63050394783186937
