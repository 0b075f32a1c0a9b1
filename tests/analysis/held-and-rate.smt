# The parts of held, rate and rising are not reported as windows; the whole is.
warn extra no-missing-way-out no-unused-element

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
[options]
step 20 ms
[local]
F64 y = 0                           #! W0205
[Run]
.step
    held(p > 50, 100 ms): -> Vent
    held(p > 40, 3 steps): -> Vent
    x = rate(p, 5 steps) + prev(p)
    rising(p > 3): -> Vent
    y = rate(p, 3 steps)            #! W0209
[Vent]
