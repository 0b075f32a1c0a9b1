spec 5.1   A declaration is a type, a name and annotations; a unit is a comment.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 a [bar] @read_only      #! E0330 a name cannot contain spaces; a unit follows '@unit', without spaces
F64 b [K]                   #! E0330 a name cannot contain spaces; a unit follows '@unit', without spaces
F64 c (psi) @read_only      #! E0330 a name cannot contain spaces; a unit follows '@unit', without spaces
F64 d psi                   #! E0330 a name cannot contain spaces; a unit follows '@unit', without spaces
F64 e read_only             #! E0330 write @read_only
F64 g-h                     #! E0330 a name consists of letters, digits and _
F64 f
[Hold]
.step
    f = a + b + c + d + e
