spec 8.23  Each run of a script begins with the initial values of its variables.
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

-- one.ss --
[options]
delta_t 1
[local]
U32 steps = 0
[all_states]
true: steps = steps + 1
G == 3: @assert steps == 4
G == 3: @stop
-- two.ss --
[options]
delta_t 1
[local]
F64 steps = 0.5
[all_states]
true: steps = steps + 1
G == 3: @assert steps == 4.5
G == 3: @stop
