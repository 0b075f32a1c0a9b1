spec 5.46  A state that is never left causes a warning, unless it is marked @safe.
warn no-all missing-way-out

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
[Start]
.step
    p > 5: -> Failed
    p > 4: -> Kept
[Kept] @safe
[Failed] @abort         #! W0920 'Failed'
