spec 6.10   Code behind a conditional that leaves in every branch draws a warning.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x > 5 {
        x = 1
        -> Hold
    }
    else if x > 3: -> Hold
    else: -> Hold
    x = 2                     #! W0504 both branches
    x = 3
[Never]                       #! W0503
.step
    x > 1 {
        x > 2: -> Hold
        else: -> Never
        x = 3
    }
    x > 5: -> Hold
    x = 4
