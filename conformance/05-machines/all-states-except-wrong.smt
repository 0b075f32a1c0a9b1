spec 5.70  Unknown and repeated names, and all states, are errors.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[all_states] @except Abrot         #! E0501 did you mean 'Abort'?
.step
    x = 1
[all_states] @except Run Run       #! E0507 'Run'
.step
    x = 1
[all_states] @except Run Abort Safe #! E0506
.step
    x = 1
[all_states] @except               #! E0365
.step
    x = 1
[all_states] @safe                 #! E0393 '@safe' is not allowed after [all_states]
.step
    x = 1
[all_states] @except Run, Abort    #! E0395
.step
    x = 1
[Run] @except Abort                #! E0393 '@except' is only allowed after [all_states]
.step
    x = 1
[Abort]
[Safe]
