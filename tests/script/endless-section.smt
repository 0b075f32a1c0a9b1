# The sections of @stop: one that ran, one that never did.
steps 9

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
    if n > 2: -> Idle
    else if p > 70: -> Idle
[Dead]
-- app.ss --
[options]
delta_t 10
[all_states]
G == 20: p = 60
G == 30: p = 0
true: @assert p >= 0
[Abort]
T == 15: @stop        #! W0702 #! E0751 section [Abort] last ran in step 4 (G = 30), and this condition was never true in it
[Dead]
T == 20: @stop
