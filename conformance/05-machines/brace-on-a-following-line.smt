spec 5.33  The opening brace may stand on a following line, after comments too; for else alike.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x
F64 y

[Run]
.step
    if a > 5
    {
        x = 1
    }
    a > 5   # warm

    # really
    {
        y = 1
    }
    if a > 50
    { x = 9 }
    else

    {
        y = y + 1
    }

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 6
    @assert x == 1
    @assert y == 2
    @stop
}
