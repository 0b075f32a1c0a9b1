spec 5.24   A machine needs at least one state.
-- app.sm --
[state_vector]                #! E0503
U64 G
U32 S
