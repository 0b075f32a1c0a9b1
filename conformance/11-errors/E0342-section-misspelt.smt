spec 5.21   A state that begins with declarations is a section whose name is misspelt.

-- app.sm --
[State_Vector]      #! E0342 did you mean '[state_vector]'?
U64 G
U32 S
F64 x
F64 p
[Locals]            #! E0342 did you mean '[local]'?
F64 a = 1
[Hold]
.step
    x = p + a
