spec 5.42   Statements after a transition in the same block draw a warning.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x > 800 {
        -> Hold
        x = 1                 #! W0501 the transition is here
        x = 2
    }
    x = 2
    x > 900: -> Hold
    x = 3
    -> Hold
    x > 5 {                   #! W0501
        x = 4
    }
