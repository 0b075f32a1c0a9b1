# Statements of states after a transition of [all_states], and a .step that only [all_states] has.
warn extra no-missing-way-out no-all-states-skipped no-unreachable-state

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y
[all_states]                #! W0519
[all_states] @except Abort Done Check
.step
    x > 3 {
        -> Done
    }
    -> Abort
[all_states] @except Abort Done Check Run
.step
    y = 3                   #! W0501 transition is here
[all_states] @except Abort Done Run
.step
    x > 8: y = 3            #! W0501 transition is here
[Check]
.entry
    x > 4: -> Run
    x > 2: -> Hold
    else:  -> Done
[Run]
.step
    x > 4: -> Check         #! W0501 transition is here
[Hold]
[Abort]
.step
    y = 0
[Done]
.step
    y = 1
