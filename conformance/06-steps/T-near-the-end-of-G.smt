spec 6.5, 6.3  Near the end of 64 bits T is still right.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step
    G > 0: -> B
[B]
.step
    x = T

-- app.ss --
[options]
delta_t 6148914691236517000

[all_states]
G > 18e18: @stop

-- trace --
2 G 6148914691236516864
3 T 0
