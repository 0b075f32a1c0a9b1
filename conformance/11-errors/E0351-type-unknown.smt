spec 2.1   There are eleven types; the message translates the type names of other languages.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[local]
float a = 1         #! E0351 did you mean 'F32'?
int b = 2           #! E0351 did you mean 'I32'?
f64 c = 3           #! E0351 did you mean 'F64'?
[Hold]
.step
    x = a + b + c + p
