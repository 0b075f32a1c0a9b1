# Ways that come back bring the value with them; ways that never come to the one that writes, nothing.
warn read-before-write
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
[local]
U32 tries = 0
F64 left = 0
[Try]
.step
    tries > 3 and T > 5: -> End
    p > 5: -> Wait
    p < -5: -> Other
[Wait]
.entry
    tries = tries + 1
.step
    T > 100: -> Try
[End]
.step
    p > left: -> End
[Other]
.entry
    left = p
.step
    p > left: -> Other
