# Findings on statements of [all_states]: useless code only where it is useless in every state, other findings with the states.
warn extra flight no-abort-single-sensor no-waits-for-sensor no-missing-way-out no-unused-element

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
F64 x
bool valve

[local]
F64 d = 0

[all_states] @except Abort
.step
    p > 50: -> Abort
    p > 5 and p < 3: x = 7           #! W0510 its parts exclude each other
    d > 0: x = 3
    x = q / d                        #! W0407 in 'Run'
    valve and q > 1: x = 5

[Run]
.entry
    valve = true
    d = 0
.step
    T > 1000: -> Vent
[Vent]
.entry
    valve = false
    d = 2
[Abort] @safe
.entry
    valve = false
[Lost]                               #! W0503
.step
    q > 1: -> Run
