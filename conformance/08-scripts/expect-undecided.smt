spec 8.35  An expect that is undecided when the script stops has failed.
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
G == 10: @expect open within 300             #! E0756 expected within 300 after G = 10, and not true up to step 3
G == 20: @stop
