spec 8.34  The time of an expect is a constant of at least 0, whose fraction is dropped.

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
[local]
F64 limit = 9.5 @read_only
F64 v = 1
[all_states]
G == 0: @expect open within limit * 2
G == 0: @expect open within x            #! E0709
G == 0: @expect open within v            #! E0709
G == 0: @expect open within -1           #! E0709
G == 0: @expect open within 0 / 0        #! E0709
G == 10: @stop
