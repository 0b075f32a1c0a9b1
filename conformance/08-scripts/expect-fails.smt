spec 8.33  An expect fails after the last step that could have met it.
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
G == 10: @expect open within 35 "opens"      #! E0756 expected within 35 after G = 10, and not true up to step 5 (G = 40, state Hold): opens
G == 50: x = 7
G == 90: @stop
