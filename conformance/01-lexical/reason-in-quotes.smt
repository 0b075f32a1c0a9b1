spec 1.35, 1.1  A reason can contain the characters that a comment can contain.
analyses on

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @allow(unused-element, "spare, -40 °C ... # [x] 'y' { @z ) \ // ; 100%")
F64 b @allow ( unused-element , "ends here" )
F64 c @allow(
    unused-element,      # why
    "over several lines"
)
F64 x
[A]
.step
    x = 1
