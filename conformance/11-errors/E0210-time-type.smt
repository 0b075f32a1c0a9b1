spec 5.3   G is a U64.
-- app.sm --
[state_vector]
F64 time @alias G     #! E0210 not F64
U32 S
[Hold]
