spec 8.24  A name of the machine, and a name of the script, cannot be declared in [local].

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
F64 pressure = 0    #! E0201 'pressure' is already used: it is an element of the machine
F64 p = 0           #! E0201 'p' is already used: it is an alias of the machine
U8  n = 0           #! E0201 'n' is already used: it is a local of the machine
U8  Hold = 0        #! E0201 'Hold' is already used: it is a state of the machine
U8  T = 0           #! E0203
U64 G = 0           #! E0201 'G'
U8  a = 0
U16 a = 0           #! E0201 'a' is already used: it is a local of the script
[all_states]
G == 3: @assert a == 0
G == 3: @stop
