spec 1.32, 5.1   Lists of declarations consist of types and names.

-- app.sm --
[state_vector]
U64 G U32
S F64

x F64 p
5               #! E0350 [state_vector]
[Hold]
.step
    x = p
