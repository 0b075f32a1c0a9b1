# Guards that wait longer than their state lasts: above the time limit and below it, in a conditional, and with the limit in an 'or'.
# Not those that can be true in the step that ends the state, and not a general limit of [all_states].
warn no-all late-timer

-- app.sm --
[options]
step 50 ms

[state_vector]
U64  time    @alias G
U32  state   @alias S
F32  line    @read_only
bool valve
bool ready

[all_states] @except Done
.step
    T > 60 s: -> Done

[Flow]
.entry
    valve = true
.step
    T > 5000 and line < 95: -> Ready          #! W0918 'T > 5000' is never true: a time limit ends the state when T is 150
    T > 120: -> Done
.exit
    valve = false

[Ready]
.entry
    ready = true
.step
    line > 105 {
        T >= 3 s: -> Flow                     #! W0918 'T >= 3 s' is never true: a time limit ends the state when T is 2000
    }
    line < 60 or T >= 2 s: -> Done
    line > 110 and T >= 2 s: -> Flow
.exit
    ready = false

[Done]
.step
    T > 980 ms: -> Flow
    T >= 1 s: -> Ready
