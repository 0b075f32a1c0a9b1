spec 8.23  A misspelt [local] of a script is reported with the right name.

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
[locals]         #! E0342 did you mean '[local]'
F64 a = 1
[all_states]
G == 3: @assert a == 1
G == 3: @stop
