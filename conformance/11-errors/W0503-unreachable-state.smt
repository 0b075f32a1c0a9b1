spec 5.29   A state that no path of transitions reaches from the first state causes a warning.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
[Idle]
.entry
    G > 5 {
        G > 10: -> Run
        else: -> Done
    }
[Run]
.step
    -> Run
    -> Behind                 #! W0501
[Done]
[Behind]                      # W0501 says so
[Lost]                        #! W0503 'Lost'
.step
    -> Loop
[Loop]                        # only Lost leads here
.step
    -> Idle
