spec 5.15   The error is at the second declaration, also where [local] comes first.
-- app.sm --
[local]
F64 pressure = 1
[state_vector]
U64 G
U32 S
F64 pressure     #! E0201 the name 'pressure' is already used: it is a local
[Hold]
