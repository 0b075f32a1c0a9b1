# `warn` takes the words behind -W and turns the analyses on.
warn no-unused-element no-error error=empty-braces

-- app.sm --
[state_vector]
U64 G
U32 S
F64 never
[local]
U8 n = 0                  #! W0204 'n'
[A]
.step
    true { }              #! W0502
[B]                       #! W0503 'B'
