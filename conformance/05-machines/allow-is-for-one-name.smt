spec 5.51  Other warnings about the covered source are reported.
analyses on

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
U8 y
U8 z
[A] @allow(constant-range, "saturates on purpose")
.step
    y = 300
    z = 1.5                               #! W0404
    x > 1 { }                             #! W0502
