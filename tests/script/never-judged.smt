# An assert that was never judged is reported once, with the reason: the condition, the state or the end.  @assert false is meant never to be judged.

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
G == 500 {
    @assert open == false               #! W0750 its condition was never true
    @assert p == 0
    @assert n > 3
}
G == 600: @assert false
G == 600: @assert limit < 3
G == 600: @assert not 1
[Idle]
G == 30 {
    @assert open == false
    @stop
}
G == 30: @assert p == 0                 #! W0750 the script had stopped before
[Abort]
true: @assert false
true: @assert p > 50                    #! W0750 the machine was never in state 'Abort'
T == 10 {
    @assert open
    @assert p == 0
}
[Dead]
true: @assert false
