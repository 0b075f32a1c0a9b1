spec 5.41  A transition in .exit is an error.

-- app.sm --
[state_vector]
U64 G
U32 S

[A]
.step
    -> B
.exit
    -> A   #! E0504

[B]
