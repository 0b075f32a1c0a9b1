spec 1.25   The labels are .entry, .step and .exit.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.start          #! E0308 did you mean '.entry'?
    x = 1
.stpe           #! E0308 did you mean '.step'?
    x = p
.foo            #! E0308 '.foo'
    x = 3
