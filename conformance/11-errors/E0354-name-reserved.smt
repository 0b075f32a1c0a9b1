spec 1.11   A reserved word cannot be a name.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 and         #! E0354 'and'
bool true       #! E0354 'true'
[Hold]
.step
    x = p
