spec 8.31  Texts and requirements follow asserts, expects, fails and prints, in any order.
on   ref vm c

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
bool open
[Hold]
.step
    open = x > 5
    x == 100: -> Vent
[Vent]
.step
    open = false
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: x = 7
G == 0: @assert open "opens" @req R7
G == 0: @assert (open and
    x == 7) @req R8 "both"
G == 0 { @expect open within 10 "quickly" @req R9 }
G == 0: @assert open @req R10
G == 0: @print x, x + 1 "the level"
G == 10: @stop
[Vent]
true: @fail "vents" @req R11
