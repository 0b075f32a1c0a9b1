spec 5.57  G counts microseconds, milliseconds or seconds.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[options]
time_unit min           #! E0374 'time_unit' expects us, ms or s, found 'min'

[Run]
.step
    x = 1
