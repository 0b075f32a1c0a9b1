spec 5.52   An @allow that no warning needs draws a warning.
analyses on

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @allow(unused-element, "x")         #! W0210 leave it out
F64 b @allow(unused-element, "x") @allow(unused-element, "y")     #! W0210
F64 c
F64 d
[A]
.step
    a = 1
    @allow(unused-allow, "x")
    @allow(dead-code, "x")
    c = 2
    @allow(unused-allow, "x")             #! W0210 '@allow(unused-allow)'
    d = 3
