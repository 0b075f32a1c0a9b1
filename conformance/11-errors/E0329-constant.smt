spec 5.9, 5.13   A constant is a local marked @read_only.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @unit bar
[local]
const F64 limit = 5             #! E0329 F64 limit = 5 @read_only
F64 const = 5 @read_only
[Hold]
.step
    x = limit + const
