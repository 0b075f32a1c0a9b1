spec 6.18  When two guards are true in one step, the first transition in source order is taken.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure

[Hold]
.step
    pressure > 10: -> Vent
    pressure > 5: -> Warn

[Warn]

[Vent]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: pressure = 12
G == 1: @assert S == 3
G == 1: @stop
