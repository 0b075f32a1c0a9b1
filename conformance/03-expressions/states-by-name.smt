spec 3.30  A state's name beside S is its number.

-- app.sm --
[state_vector]
U64 G
U32 mode @alias S
F64 x
F64 y
bool z

[Idle]
.step
    mode == Idle: x = 1
    Idle != S: x = 2
    y = 10 * (S == Idle) + ((mode) != (Run))
    T > 1: -> Run
.exit
    z = S == Idle and not (mode == Run)

[Run]
.step
    S == Run { x = 3 } else { x = 4 }
    z = z and S != Idle and mode != Idle or S == Idle

-- app.ss --
[options]
delta_t 1

[Idle]
T < 2 {
    @assert x == 1
    @assert y == 11
    @assert S == Idle   #! W0752
    @assert mode != Run   #! W0752
}

[Run]
T == 1 {
    @assert x == 3
    @assert Run == S   #! W0752
    @assert z
    @stop
}
