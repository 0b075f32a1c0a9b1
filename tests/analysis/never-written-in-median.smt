# A local that nothing assigns, as a value of median: marked @read_only it would be an error, so smc fix does not mark it.
warn never-written
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
[local]
F64 pLimit = 5                      #! W0207 for a limit, use min, max or clamp
F64 scale = 2                       #! W0207
[Run] @safe
.step
    x = median(p, pLimit) + average(p, p * scale)
