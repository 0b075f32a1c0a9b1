spec 8.1, 1.17  The number is an F64 like any other: 9007199254740993 is 9007199254740992.

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
delta_t 9007199254740993

[all_states]
G > 0: @stop

-- trace --
2 G 9007199254740992
