spec 8.23  Initial values are computed before the run: from numbers, locals of the machine, and variables declared above.

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
F64 a = pressure        #! E0406 'pressure'
F64 b = c               #! E0408 'c'
F64 c = roll_avg(n, 2)  #! E0409
F64 d                   #! E0355
F64 e = T               #! E0406
F64 f = f               #! E0407
F64 g = limit
[all_states]
G == 3: @assert g == 8 and h   #! E0204 'h'
G == 3: @stop
