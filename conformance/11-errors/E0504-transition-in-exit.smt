spec 5.41   A transition in .exit is an error, inside conditionals too.
-- app.sm --
[state_vector]
U64 G
U32 S
[Hold]
.step
    -> Abort
.exit
    -> Abort                  #! E0504
[Abort]
.exit
    G > 5 {
        S == 1: -> Hold       #! E0504
    }
    else: -> Nowhere          #! E0504 .exit #! E0501 'Nowhere'
