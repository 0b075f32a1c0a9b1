spec 1.26  An element has one alias.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @alias a @alias b   #! E0361
F64 y

[Run]
.step
    y = x
