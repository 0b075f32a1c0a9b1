spec 1.11, 5.20   Words that mean true and false elsewhere are unknown names; the message names the right word.

-- app.sm --
[state_vector]
U64 G
U32 S
bool x
bool on
[Hold]
.step
    x = True            #! E0204 did you mean 'true'?
    x = FALSE           #! E0204 did you mean 'false'?
    x = off             #! E0204 did you mean 'false'?
    x = on
    on: x = false
    ELSE: x = true      #! E0204 did you mean 'else'?
