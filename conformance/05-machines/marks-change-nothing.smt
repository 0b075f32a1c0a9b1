spec 5.44  Annotations never change the behaviour of a program.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure @range 0 40
F64 seen

[Abort] @abort @safe
.entry
    seen = pressure
.step
    pressure > 50: -> Run
.exit
    seen = seen + 1

[Run] @safe @swap
.step
    pressure < 0: -> Abort
    seen = pressure

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: pressure = 40
G == 0: @assert S == 1 and seen == 40
G == 1: pressure = 51
G == 1: @assert S == 1 and seen == 41
G == 2: @assert S == 2 and seen == 51
G == 3: pressure = -100
G == 3: @assert S == 2 and seen == 51
G == 4: @assert S == 1 and seen == -100
G == 4: @stop
