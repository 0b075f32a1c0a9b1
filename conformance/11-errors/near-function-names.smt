spec 3.9   An element may be called like a function.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 max @read_only
bool on
[Hold]
.step
    on = max > 5 and (max <
      3 or max == 4)
    max > 8: on = false
