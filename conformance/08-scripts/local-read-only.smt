spec 8.25  A script cannot assign its own @read_only variable, and its variables have no other annotation.

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
F64 a = 1 @read_only
F64 b = 1 @range 0 1        #! E0362 '@range' is allowed only on elements of the state vector
F64 c = 1 @alias d          #! E0362 '@alias'
F64 e = 1 @allow(extra, "x")   #! E0362 '@allow' is allowed only on machines and state vectors
[all_states]
G == 3: a = 2               #! E0213 'a'
G == 3: @stop
