# Where no transition was made.
steps 3

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
[all_states]
true: @assert p >= 0
[Dead]
T == 20: @stop      #! E0751 the machine has been in state 'Idle' from the start
