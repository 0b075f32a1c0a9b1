# Transitions to an @abort state that are meant for every case, or depend on a condition.
warn no-all unguarded-abort

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool hot @read_only
U8 code
U8 level
[Braces]
.step
    p > 50 {
        code = 1
        -> Abort
    }
    hot: -> Abort
    p > 40: -> Abort
[Said]
.step
    p > 50: code = 1
    true: -> Abort
[Apart]
.step
    p > 50: code = 1

    -> Abort
[Explained]
.step
    p > 50: code = 1
    # Whatever it was, the flight is over.
    -> Abort
[Chosen]
.step
    p > 50: -> Done
    -> Abort
[Both]
.step
    p > 50: code = 1
    else: level = 2
    -> Abort
[Classified]
.step
    code = 9
    p > 50: code = 1
    -> Abort
[Chain]
.step
    if p > 50: code = 1
    else if p > 40: code = 2
    -> Abort
[Several]
.step
    p > 50: code = 1
    hot { code = 2 }
    p > 10: code = 3
    -> Abort
[Passing]
.entry
    p > 50: code = 1
    -> Abort
[Failing] @abort
.step
    p > 50: code = 1
    -> Abort
[Inside]
.step
    hot {
        p > 50: code = 1
        -> Abort
    }
[Other]
.step
    p > 50: code = 1
    -> Done
[Allowed]
.step
    p > 50: code = 1
    @allow(unguarded-abort, "the state only records the pressure") -> Abort
[Done] @safe
.exit
    level = 1
[Abort] @abort @safe
