# A limit to T that one step may pass, or a thousand: the step is not known.
warn window-not-full
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
[Wait]
.step
    T > 5: -> Calm
[Calm]
.step
    roll_avg(p, 100) > 5: -> Wait
