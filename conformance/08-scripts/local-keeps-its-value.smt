spec 8.26  A variable of the script keeps its value through steps and transitions, and a machine does not see it.
on   ref vm c

-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure @alias p
bool valveOpen

[local]
U8 n = 3
F64 limit = 8 @read_only

[Hold]
.step
    valveOpen = pressure > limit + n - n
    pressure > 100: -> Vent

[Vent]

-- app.ss --
[options]
delta_t 1
[local]
U32 steps = 0
F64 before = -1
[all_states]
true: before = steps
true: steps = steps + 1
G == 3: pressure = 200
G == 5: @assert steps == 6 and before == 5 and S == 2 and roll_avg(steps, 3) == 4
G == 5: @stop
