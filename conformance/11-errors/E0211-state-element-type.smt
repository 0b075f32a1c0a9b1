spec 5.4   S is a U32.
-- app.sm --
[state_vector]
U64 G
U8 state @alias S     #! E0211 not U8
[Hold]
