spec 1.29, 1.32   A header may follow declarations on their line; it is no unit then.
-- app.sm --
[state_vector] U64 G U32 S F64 x [local]
F64 y = 1 @read_only
[Hold] .step x = y -> Idle  #! E0330 line of its own
[Idle] @safe
