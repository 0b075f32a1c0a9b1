spec 8.35  Undecided expects are judged before what the step has noted, in the order in which they began.
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
G == 10: @expect x == 2 within 10
G == 0:  @expect x == 1 within 20            #! E0756 after G = 0
G == 20: @assert false
G == 20: @stop
