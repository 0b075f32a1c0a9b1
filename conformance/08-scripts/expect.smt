spec 8.33, 8.35  An expect passes at any step in its time, its own and the last included, and in any state.
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
[Hold]
G == 0: @expect T == 0 within 0 ms
G == 10: @expect open within 30 "at 40"
G == 40: x = 7
G == 60: x = 100
G == 60: @expect S == 2 and T == 20 within 0.03 s
[all_states]
G == 90: @stop
