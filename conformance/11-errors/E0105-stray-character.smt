spec 1.21   A character that means nothing in the language is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = $p      #! E0105 '$'
    x = \p      #! E0105 '\'
