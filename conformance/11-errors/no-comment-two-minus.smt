spec 3.1   Two minus signs are two operators wherever an expression follows them.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
bool on
[Hold]
.step
    x = p--1
    x = x -- p
    x = x -- p + x
    --x > 3: on = p -- x > 1 and p > x
    --x  # the guard of what stands below
    {
        on = true
    }
    --(x +
        p) > 2: on = true
    not on: -> Vent
[Vent]
