# What it was in the step before, and what no longer changes.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  p     @read_only
F32  alt   @read_only
bool flood
bool landed
[local]
F32 before = 0
[Watch] @safe
.entry
    before = p
.step
    before - p > 8: flood = true                                        #! W0903 'p' alone switches on 'flood' when it reads 0
    before = p
    T > 1000 and roll_range(alt, 50) < 2: landed = true                              #! W0903 'alt' alone switches on 'landed'
