spec 5.29   A state that does not exist is an error, reported once.
-- app.sm --
[state_vector]
U64 G
U32 S
[Hold]
.step
    G > 800: -> Abbort        #! E0501 did you mean 'Abort'?
    G > 900: -> Nowhere       #! E0501 add a section [Nowhere]
    G > 950: -> all_states    #! E0501 name the state to go to
[Abort]
.step
    -> Abbort
