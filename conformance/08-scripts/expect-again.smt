spec 8.35  An expect begins again after it has passed.
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
G == 10: x = 7
G == 20: x = 0
x == 0: @expect open within 20     #! E0756 expected within 20 after G = 20
G == 90: @stop
