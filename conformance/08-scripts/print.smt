spec 8.36  A print shows values and tests nothing.
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
true: @print x, open
G == 900: @stop                        #! W0751
