spec 5.3   G is an element, not a local.
-- app.sm --
[state_vector]
U32 S
[local]
U64 G = 0             #! E0210 not a local
[Hold]
