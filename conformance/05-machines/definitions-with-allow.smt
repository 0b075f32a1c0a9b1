spec 5.50, 5.61  A finding inside a definition is accepted at the definition.
warn extra

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
[define]
drop = p < roll_max(x, 3) - 5 @allow(late-sample, "one step later is early enough")
[Run]
.step
    x = p + 1
    drop: -> Done
[Done]
