spec 3.32  `not` applies to S alone.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Idle]
.step
    @allow(not-precedence, "the mistake of this case")
    not S == Idle: x = 1            #! E0204 write S != Idle
