spec 1.11, 1.24   A reserved word cannot be the name of a state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[if]            #! E0306 'if'
.step
    x = p
[F64]           #! E0306 'F64'
