spec 8.6  A script knows no @allow.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
[A]
.step
    a = 1
-- app.ss --
[options]
delta_t 1
[all_states]
true {
    @allow(unjudged-assert, "x")          #! E0340 in a machine or a state vector
    @stop
}
