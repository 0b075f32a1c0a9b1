spec 5.21   Only comments can precede the first section.

-- app.sm --
# a comment
F64 y           #! E0301 this must be in a section
F64 z
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p
