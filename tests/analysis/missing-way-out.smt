# States that are never left: without a transition, with one to itself alone, with one that cannot be made.
warn no-all missing-way-out

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
U8  n @read_only
[Start]
.step
    p > 5: -> Failed
    p > 4: -> Kept
    p > 3: -> Locked
    p > 2: -> Itself
    p > 1: -> Alone
[Alone]                 #! W0920 the machine can never leave 'Alone'
[Itself]                #! W0920
.step
    p > 5: -> Itself
[Locked]                #! W0920
.step
    n > 300: -> Start
[Kept] @safe            # on purpose
[Failed] @abort         #! W0920 'Failed'
[Nowhere]               # it is not reached: another finding
