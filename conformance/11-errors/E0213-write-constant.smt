spec 5.13   A local marked @read_only cannot be assigned.
-- app.sm --
[state_vector]
U64 G
U32 S
[local]
F64 limit = 800 @read_only
[Hold]
.step
    limit = 900       #! E0213 @read_only local
