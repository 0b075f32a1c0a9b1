spec 5.19  A state may bear the name of an element, a local, an alias, of T or of a function.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 Vent @alias v

[local]
F64 Hold = 2

[Hold]
.step
    Vent = Hold
    -> Vent

[Vent]
.step
    Vent = Vent + Hold
    -> v

[v]
.step
    v = v * 10
    -> T

[T]
.step
    v = v + T
    -> abs

[abs]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 2: @assert Vent == 40
G == 3: @assert v == 40
G == 4: @assert S == 5
G == 4: @stop
