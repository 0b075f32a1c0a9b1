spec 5.52  An @allow that no warning needs draws a warning.
analyses on

-- app.sv --
[R]
U64 G
U32 S
F64 x @allow(unused-element, "some machines do not need it")
F64 y
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y @allow(unused-element, "not true")  #! W0210 '@allow(unused-element)'
[local]
U8 n = 1 @allow(never-written, "x") @allow(unused-local, "not true")  #! W0210 '@allow(unused-local)'
[A] @allow(empty-braces, "outer")         #! W0210 '@allow(empty-braces)'
.step
    x = n
    @allow(empty-braces, "inner")
    y > 1 { }
    @allow(dead-code, "not true")         #! W0210
    y = 1
