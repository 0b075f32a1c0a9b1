spec 8.35  The guard of an undecided expect has no effect on it: the oldest one counts.
expect fail
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
true: @expect open within 30                 #! E0756 expected within 30 after G = 0, and not true up to step 4
G == 40: x = 7
G == 90: @stop
