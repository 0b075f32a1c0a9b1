# A script that asserts nothing passes, and says so at its @stop.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool open
[local]
U8 limit = 50 @read_only
U8 n = 0
[Idle]
.step
    n = n + 1
    open = p > 5
    p > limit: -> Abort
[Abort]
.entry
    p > 90: -> Dead
.step
    open = false
    if n > 4: -> Idle
    else if p > 70: -> Idle
[Dead]
-- app.ss --
[options]
delta_t 10
[Idle]
G == 20: @stop      #! W0751 it tests only that @stop is reached
[all_states]
G == 500: @stop
