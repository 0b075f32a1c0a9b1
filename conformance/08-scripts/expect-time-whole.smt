spec 8.34  The fraction of the time is dropped.
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
G == 0: @expect open within 9.99         #! E0756 expected within 9 after G = 0, and not true up to step 1
G == 10: x = 7
G == 20: @stop
