spec 8.33  A time beyond 64 bits never ends.
expect fail
steps 100
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
G == 0: @expect open within 1e30       #! E0756 expected within 18446744073709551615
G == 900: @stop
