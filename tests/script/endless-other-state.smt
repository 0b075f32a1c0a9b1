# A script that does not stop tells since when the machine is where it is, and why each @stop did not come.
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
G == 1000 and p < 3: @stop              #! E0751 the machine has been in state 'Idle' since step 5 (G = 40)
true: @assert p >= 0
