# A local that nothing assigns is not marked @read_only where median would then refuse it.
args fix a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
[local]
F64 pLimit = 5
F64 scale = 2
[Run] @safe
.step
    x = median(p, pLimit) * scale
-- file a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
[local]
F64 pLimit = 5
F64 scale = 2 @read_only
[Run] @safe
.step
    x = median(p, pLimit) * scale
-- stdout --
a.sm:[..]
...
-- stderr --
a.sm:7:5: warning: local 'pLimit' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
    7 | F64 pLimit = 5
      |     ^~~~~~ but median and average take no constants: for a limit, use min, max or clamp
1 warning
