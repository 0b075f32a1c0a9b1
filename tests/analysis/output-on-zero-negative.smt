# A reading that is never above 0 while the sensor is healthy.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  lox  @read_only @range -200 -100
bool vent
[Hold]
.step
    lox > -130: -> Relief             #! W0903 'lox' alone switches on 'vent' when it reads 0
[Relief] @safe
.entry
    vent = true
