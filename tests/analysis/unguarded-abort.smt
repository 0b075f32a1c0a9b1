# A transition to an @abort state below a conditional of one line, which looks as if it depended on it.
warn no-all unguarded-abort

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool hot @read_only
U8 code
U8 level
[Burn]
.step
    T > 5000: -> Done
    p > 50: code = 1
    -> Abort                    #! W0517 always taken
[Hold]
.entry
    level = 3
    if p > 50: code = 1         # too high
    -> Abort                    #! W0517
.step
    level = 2
[Wait]
.step
    p > 50 { level = 2 }
    hot: p > 40: code = 2
    -> Vented                   #! W0517 'Vented'
[Other]
.step
    p > 50: code = 1
    @allow(dead-store, "another warning") -> Abort   #! W0517
[Done]
.step
    p > 50: code = 1
        -> Abort                #! W0517 always taken
[Else]
.step
    hot: code = 1
    else: code = 2
        -> Abort                #! W0517 always taken
[Abort] @abort @safe
[Vented] @abort @safe
