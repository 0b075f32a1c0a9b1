spec 5.45   Annotations of states are allowed after headers only.

-- app.sm --
[state_vector] @safe      #! E0375 as in [Name] @safe
U64 G
U32 S
bool open
[local] @abort            #! E0375
[Hold @safe]              #! E0120 write [Hold] @safe
.step
    open = true
@abort                    #! E0340 as in [Name] @abort
[Abort]
.entry
    open = false
