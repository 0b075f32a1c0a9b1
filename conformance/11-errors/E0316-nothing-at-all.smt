spec 5.38   A colon needs a statement also before a closing brace and at the end of the file.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p > 5 { x > 5: }      #! E0316 '}'
    p > 7:                #! E0316 the condition
