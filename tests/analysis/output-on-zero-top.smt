# At an end of the range.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  tankP @read_only @range 0 90
bool vent
[Watch] @safe
.step
    vent = tankP > 55                                                   #! W0903 'tankP' alone switches on 'vent' when it reads 90
