spec 1.35   A reason is between two ASCII quotation marks.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @allow(unused-element, 'abc')       #! E0389
F64 b @allow(unused-element, “abc”)       #! E0389
F64 c @allow(unused-element, "abc)        #! E0389
F64 d @allow(unused-element, "it's")
[A]
.step
    a = b + c + d
