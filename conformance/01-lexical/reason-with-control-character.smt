spec 1.35, 1.5  Control characters have no place in a reason.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @allow(unused-element, "ab")     #! E0101
[A]
.step
    a = 1
