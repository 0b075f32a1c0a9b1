# Through windows, locals and filters.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  pressure @read_only
F64  wall     @read_only
bool a
bool b
bool c
bool d
[local]
F64  filtered = 0
bool cold = false
F64  least = 5 @read_only

[Derived]
.entry
    a = false
    b = false
    c = false
    d = false
    filtered = 100
.step
    roll_avg(pressure, 10) < 5: a = true                #! W0903 'a'
    cold = wall < 10
    cold: b = true                                      #! W0903 'wall' alone switches on 'b'
    filtered = filtered + 0.1 * (pressure - filtered)
    filtered < 15: c = true                             #! W0903 'c'
    pressure < least: d = true                          #! W0903 'd'
    T > 5000: -> Done
[Done] @safe
