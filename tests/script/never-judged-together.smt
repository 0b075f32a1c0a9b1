# How many asserts one warning stands for.

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
G == 20: @assert open == false
G == 30: @stop
[Abort]
true: @assert false
true: @assert p > 50                    #! W0750 with this one, 3 asserts were not evaluated for this reason
T == 10 {
    @assert open
    @assert p == 0
}
