spec 1.24   A state must be named so that it can be written after ->.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[2nd]           #! E0305 '2nd'
.step
    x = p
[pad/hold]      #! E0305 'pad/hold'
