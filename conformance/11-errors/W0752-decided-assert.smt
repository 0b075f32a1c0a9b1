spec 8.18   An assert in the section of a state is judged in that state only.

-- app.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    T >= 2: -> Open
[Open] @safe
.entry
    open = true
-- app.ss --
[options]
delta_t 1
[Idle]
true: @assert S == Idle                         #! W0752 this condition cannot be false here
true: @assert not open and S != Open            #! W0752
true: @assert not open or S == Idle
[Open]
T == 1: @assert state Open and open             #! W0752 this condition cannot be false here
[all_states]
G == 4: @assert S == Open
G == 4: @stop
